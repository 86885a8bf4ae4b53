// A program of facts, to be read, checked and compiled; run_workloads adds n of them.
edge(0, node_0, "text 0").
!start.
+!start : edge(0, _, _).
