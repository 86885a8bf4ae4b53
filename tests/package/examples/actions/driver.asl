speed(13).
blocked(1).
safe(Lane) :- road.lane(Lane) & not blocked(Lane).

!drive.
+!drive : speed(V) & road.braking_distance(V, D) & D < 20
  <- .print(road.kmh(V), " km/h, stops within ", D, " m");
     .findall(Lane, safe(Lane), Lanes); .print("lanes ", Lanes);
     !guess.
+!guess <- road.braking_distance(fast, D).
-!guess[error(E), error_msg(M)] <- .print(E, ": ", M).
