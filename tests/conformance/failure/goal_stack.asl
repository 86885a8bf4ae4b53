// A dropped intention is logged with the goals that were under way, and the place of the formula.
!go.
+!go <- !cross(left).
+!cross(Way) <- +way(Way); act(Way).
// expect log: agent.asl:4:28: no failure event was generated: action_failed
// expect log: goals: go (
// expect log: > cross(left) (
