// .kqml_answer: each answer to a question, without source(self).
b(1). b(2)[k].
!start.
+!start <- .findall(A, .kqml_answer(b(_), A), L); .print(L); if (not .kqml_answer(none, _)) { .print("none") }.
// expect: [b(1),b(2)[k]]
// expect: none
