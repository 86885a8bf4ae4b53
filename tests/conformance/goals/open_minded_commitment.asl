// omc(g, f, m): when f is believed the intention of g is dropped, with whatever goal it is for; g counts as
// achieved when m is no longer believed.
{ begin omc(at(X), broken, wanted) }
+!at(X) <- .print("tries ", X); .wait(10000); .print("never").
{ end }
wanted.
!start.
+!start <- !!caller(1); .wait(250); -wanted; .wait(10); +wanted; !!caller(2); .wait(150); +broken; .wait(300); .print("end").
+!caller(X) <- !at(X); .print("after ", X).
// expect: tries 1
// expect: after 1
// expect: tries 2
// expect: end
