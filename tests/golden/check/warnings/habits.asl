// Everything here parses.
side(left). side(right).
age(ann, 31).

!start.
!greet(bob).

+!start : side(rigth) & ground(lnae) <- move(lft); move(up); !Walk.
+!start : ground(grass) <- L = .concat([1], [2]); N = .length(L); .print(L, N).
+!start : age(ann, a) & a > 18 <- .send(bob, tel, side(left)); .broadcast(achive, start).
+!start <- age(ann, X); .print(X); -+side(lefft); !walk(rihgt).

+!greet(person) <- .print("hello ", person).
+!walk(Way) <- move(Way).

// jaywalk: allow unknown-golas, unknown-goal
@named(1)[atomic] +!labelled <- stay
  .print(x).
// jaywalk: allow missing-semicolon, label-arguments
@named(2)[atomic] +!silent <- stay .print(x).
