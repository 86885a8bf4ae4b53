// What Jason's grammar accepts, though one might not think so.
{
	include("elsewhere.asl", other)
}
{begin namespace(mine,local)}
  price(bridge,300).
  +!forget <- .abolish(::_); .drop_desire(::_); .abolish(_::_[source(_)]).
{end}
!start ("now").
+!start(_) <- !mine::forget; !retry; !first([a,b]).
+N::announced[source(bob)]
  : .member(N,[mine,default])
  <- .add_plan({ +?N::gain (T) : mine::price(T,P)
                   <- P > 1
               }).
+tick(Param) [artifact_name(Id,Name)] <- .print("tick ",Param," ",Id,Name);.
+alive [source(X)]
:
	true
<-
	.print(X)
.
-!retry
  <- .wait(100)
     !retry.
+!retry : N = 3 & not(N == 4) & (N > 1 | alive) <-
  if (not ready){
    .date(_,_,_);
  }
  .wait(10);
  for (.range(I,1,2)) { .print(I); };
  while (not ready) { +ready; } !done
.
+!done.
+!first(L) <- [A|_] = L; road(A,_) = road(B,1); .print(B); .
ready :- alive
         | tick(_).
