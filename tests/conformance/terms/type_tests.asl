// What is an atom, a structure, a literal ...
!start.
+!start <-
  .findall(T, .member(T, [1, "s", a, f(1), [1], a[k], ~b]) & .atom(T), A); .print(A);
  .findall(T, .member(T, [1, "s", a, f(1), [1]]) & .number(T), N); .print(N);
  .findall(T, .member(T, [1, "s", a, f(1), [1]]) & .string(T), S); .print(S);
  .findall(T, .member(T, [1, "s", a, f(1), [1]]) & .list(T), L); .print(L);
  .findall(T, .member(T, [1, "s", a, f(1), [1]]) & .literal(T), R); .print(R).
// expect: [a]
// expect: [1]
// expect: ["s"]
// expect: [[1]]
// expect: [a,f(1)]
