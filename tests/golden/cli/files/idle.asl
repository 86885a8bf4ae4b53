// A pedestrian that stays where it is.
+tick(_) <- stay.
