// A belief has all the sources that said it.
// agent ann
+!go <- .send(bob, tell, rain); .send(bob, achieve, look).
!go.
// agent bob
rain.
+!look <- .findall(S, rain[source(S)], L); .print(L).
// expect [bob]: [ann,self]
