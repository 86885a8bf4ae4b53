// A directive that does not exist is refused.
{ begin bgd(g) }
+!g <- .print(g).
{ end }
// expect error 2:9: there is no directive 'bgd'
