// A plan made at run time is used from then on.
!start.
+!start <- !try; .add_plan({ +!try <- .print("added") }); !try.
-!try <- .print("no plan yet").
// expect: no plan yet
// expect: added
