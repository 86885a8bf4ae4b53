// A pedestrian that never makes up its mind.
+tick(_) <- !think.
+!think <- !think.
