Unknown(1).
.print("at top level").
+!go : .wait(100) <- stay.
+!go <- ~.print(1)[a]; X = a + 1; 1 < 2 < 3.
+!go <- if (at(X, Y)) { stay } else if (grid(X, Y)) { stay }.
+!go <- !{ +!stop }; +.print(1).
{ end }
mod(1).
b(1).c(2).
