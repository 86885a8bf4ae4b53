// Literals of a namespace are others than those outside.
b(1).
shop::b(2).
{begin namespace(shop)}
b(3).
+!list : b(X) & not b(1) <- .print(X).
{end}
!start.
+!start <- .findall(X, b(X), L); .print(L); !shop::list.
// expect: [1]
// expect: 2
