// One plan among those for act, whose first arguments differ.
n(1000).
!start.
+!start : n(N) <- !loop(N).
+!loop(0).
+!loop(N) <- !act(k7); !loop(N-1).
+!act(k1). +!act(k2). +!act(k3). +!act(k4). +!act(k5). +!act(k6). +!act(k7). +!act(k8).
