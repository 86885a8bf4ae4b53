// .list_files: what lies in a folder and below; nothing matches, nothing is listed. A folder that
// cannot be listed has no files, with a warning.
!start.
+!start
  <- .list_files("tests/conformance/actions/clock", "none_such", L); .print(L);
     .list_files("/no/such/folder", M); .print(M);
     .list_files("tests/conformance/README.md", ".*", N); .print(N).
// expect: []
// expect: []
// expect: []
// expect log: cannot list /no/such/folder: No such file or directory
// expect log: cannot list tests/conformance/README.md: Not a directory
