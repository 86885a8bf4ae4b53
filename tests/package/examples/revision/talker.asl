!talk.
+!talk <- .my_name(Me); .concat(Me, "'s door", Door); .send(guard, achieve, open(Door)).
