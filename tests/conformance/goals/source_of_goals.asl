// Goals have the source self.
!start.
+!start[source(S)] <- .print(S); !sub.
+!sub[source(S)] <- .print(S).
// expect: self
// expect: self
