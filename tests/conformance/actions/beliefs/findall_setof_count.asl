// .findall keeps order and duplicates; .setof sorts without.
b(2, x). b(1, y). b(2, z).
!start.
+!start <- .findall(N, b(N, _), L); .setof(N, b(N, _), S); .count(b(2, _), C); .print(L, S, C); .findall(N, b(9, N), E); .print(E).
// expect: [2,1,2][1,2]2
// expect: []
