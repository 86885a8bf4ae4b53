// +{plan} adds before the others, +>{plan} behind them.
!start.
+!start <- !g; +{ +!g <- .print("new first") }; !g; +>{ +!h <- .print("second") }; !h.
+!g <- .print("old").
+!h <- .print("first").
// expect: old
// expect: new first
// expect: first
