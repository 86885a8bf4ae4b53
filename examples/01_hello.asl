// 1. Hello: an agent believes something, wants something, and has a plan for it.
//
//   jaywalk run examples/01_hello.asl

likes(ann, tea).  // beliefs: what the agent takes to be true
likes(bob, coffee).

!serve(ann).  // goals: what it wants done
!serve(bob).

+!serve(Who)                      // a plan: when this goal comes up
  : likes(Who, What)              // and this is believed (capitals are variables)
  <- .print(What, " for ", Who).  // do this
