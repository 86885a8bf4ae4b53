// .list_files: what lies in a folder and below; nothing matches, nothing is listed.
!start.
+!start
  <- .list_files("tests/conformance/actions/clock", "none_such", L); .print(L).
// expect: []
