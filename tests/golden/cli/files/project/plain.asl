!go.
+!go <- .print("no name, "); .print("no line break"); .println(", but here");
        .log(info,"not with verbose=0"); .verbose(1); .print("named again").
