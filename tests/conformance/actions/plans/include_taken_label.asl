// A label that another plan has is an error; nothing of the file is taken over then. The same plan
// once more is none.
// expect: internal_action
// expect: []
// expect: included
@l +!p <- .print(mine).
@same +!q <- .print(same).
!go.
+!go <- .include("other.asl").
-!go[error(E)] <- .print(E); .findall(X,other(X),L); .print(L); .include("alike.asl"); .print(included).

// file other.asl
other(1).
@l +!p <- .print(other).
// file alike.asl
@same +!q <- .print(same).
