// bdg: each plan is followed by a test of the goal; when it does not hold, the next one is tried.
!start.
+!start <- !open(door); .print("open").
{ begin bdg(open(door)) }
+!open(door) : not tried(push) <- +tried(push); .print("push").
+!open(door) : not tried(pull) <- +tried(pull); .print("pull"); +open(door).
{ end }
// expect: push
// expect: open
