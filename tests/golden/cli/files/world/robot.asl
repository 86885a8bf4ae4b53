+door(shut) <- !open.
+!open <- open(door); .print("opened").
-!open[error_msg(Why)] <- .print("not yet: ", Why); unlock(door); !open.
+door(open) <- .print("the door is open"); greet.
