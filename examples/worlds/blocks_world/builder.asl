// Builds towers from the table up; what is in the way is put on the table.

wanted(a, e).
wanted(e, b).
wanted(b, table).
wanted(f, d).
wanted(d, c).
wanted(c, table).
wanted(g, table).

free(table).
free(Block) :- not on(_, Block).

// A block has its place when all below it have theirs.
placed(table).
placed(Block) :- wanted(Block, Below) & on(Block, Below) & placed(Below).

!build.

+!build : wanted(Block, Place) & placed(Place) & free(Place) & not placed(Block) & free(Block)
  <- .print(Block, " belongs onto ", Place);
     move(Block, Place);
     !build.
+!build : on(Block, Below) & Below \== table & not placed(Block) & free(Block)
  <- .print(Block, " is in the way");
     move(Block, table);
     !build.
+!build <- .print("All blocks are where I want them.").
