// .perceive looks at the world now, although the settings say that only every 100th cycle does; see also settings/nrcbp.
// environment: board
// settings: nrcbp=100
!start.
+!start <- show(a); if (not a) { .print("not yet") }; .perceive; if (a) { .print("seen") }; .perceive; if (a) { .print("still") }.
// expect: not yet
// expect: seen
// expect: still
