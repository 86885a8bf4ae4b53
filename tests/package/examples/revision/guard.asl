!watch.

+!watch <- +rumour(fire); +position(door); +position(gate); +position(yard);
           .findall(P, position(P), Now); .findall(R, rumour(R), Heard); .print(Now, Heard).
+position(P) <- .print("now at the ", P).
+!open(What)[source(Who)] <- .print("opening the ", What, " for the ", Who).
