+temperature(T) <- .print(T, " degrees"); !comfort(T).

+!comfort(T) : T < 19 <- heat(3).
+!comfort(20) <- cool.
+!comfort(_) <- rest.
-!comfort(_)[error(action_failed), error_msg(Why)] <- .print(Why).
