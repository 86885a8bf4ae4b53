// A plan without label that is told gets a label of the receiver's own.
// agent asker
!start.
+!start <- .send(teacher, askHow, {+!g}); .wait(100); !g; !h.
+!h <- .print(h).
// expect [asker]: g
// expect [asker]: h
// agent teacher
+!first <- .print(first).
+!g <- .print(g).
