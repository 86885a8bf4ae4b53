/* strings, numbers and odd layout */ s("quote \" and \n line"). s('quoted atom'). s(""). big(1e300).big2(.5).
tiny(1.5e-10). neg(-3). list([a,[b,[c|D]]|[]]).
!t(  "x" ,_,_1,_1a ).
+!t(A,B,C,D)<-.concat(A,"-",1/3,R);.print(R,B,C);.length(R,N);.print(N+0.0);?big(X);.print(X*X,-X*X,0/0);
for(s(S)){.print(S,[S])};.print({});.print([|T]);true;X2=.print(nested);X2;.sort([b,"a",1,[],f(x),X3,~b],Q);.print(Q).
