!start.
+!start.
