// Jason's own actions have the names of their classes, too.
// expect: [1,2]
// expect: 3
!go.
+!go <- jason.stdlib.findall(X,jason.stdlib.range(X,1,2),L); jason.stdlib.print(L);
        jason.stdlib.length([a,b,c],N); .print(N).
