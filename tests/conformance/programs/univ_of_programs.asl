// =.. takes programs apart as the structures that they are.
!start.
+!start
  <- {!g(a)[b]} =.. L1; .print(L1);
     {?g(a); !h; +z} =.. L2; .print(L2);
     {.print(a)} =.. L3; .print(L3);
     {act(1)} =.. L4; .print(L4);
     {} =.. L5; .print(L5);
     for (.member(B, [{!!g},{+g},{+<g},{-g},{++g},{--g},{-+g},{+>g},{Y > 1}])) {
       B =.. [_,F,[A],_]; .print(F," ",A)
     };
     {p(X) :- q(X) & r} =.. L6; .print(L6);
     F1 = (a & b(X)); F1 =.. L7; .print(L7);
     F2 = (a | c); F2 =.. [_,_,L8,_]; .print(L8);
     F3 = (X > 1); F3 =.. L9; .print(L9);
     F4 = (not a); F4 =.. L10; .print(L10);
     {@l +!g : c <- a; b} =.. [L,T,C,D]; .print(L," ",T," ",C," ",D).
// expect: [default,achieve,[g(a)[b]],[]]
// expect: [default,test,[g(a),{ !h; +z }],[]]
// expect: [default,internalAction,[.print(a)],[]]
// expect: [default,action,[act(1)],[]]
// expect: [default,none,[],[]]
// expect: achieveNF g
// expect: addBel g
// expect: addBel g
// expect: delBel g
// expect: addBelNewFocus g
// expect: delBelNewFocus g
// expect: delAddBel g
// expect: addBelEnd g
// expect: constraint (Y > 1)
// expect: [default,p,[X],[]]
// expect: [default, & ,[a,b(X)],[]]
// expect: [a,c]
// expect: [default, > ,[X,1],[]]
// expect: [default,not ,[a],[]]
// expect: l +!g c a; b
