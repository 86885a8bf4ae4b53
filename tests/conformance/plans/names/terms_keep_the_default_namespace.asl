// Within a namespace, arguments keep the default one.
{begin namespace(shop)}
item(apple).
!start.
+!start <- ?item(X); .print(X); ?item(default::apple); .print("same").
{end}
// expect: apple
// expect: same
