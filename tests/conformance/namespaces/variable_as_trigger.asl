// A variable as a trigger takes the goals of its module.
{ begin namespace(m) }
!go.
+!go <- .print("m go").
+!G <- .print("m any ",G).
!other.
{ end }
!third.
+!G <- .print("any ",G).
// expect: m go
// expect: m any other[source(self)]
// expect: any third[source(self)]
