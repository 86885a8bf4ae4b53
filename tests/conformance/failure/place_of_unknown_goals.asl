// A goal that another agent has sent has no place in the program.
// agent bob
!go.
+!go <- .send(mia, achieve, dance(1)).
// agent mia
-!dance(_)[error(E), code(C), code_src(S), code_line(L)] <- .print(E, " ", C, " ", S, " ", L).
// expect [mia]: no_relevant dance(1)[source(bob)] no_code no_code
