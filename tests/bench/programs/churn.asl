// Annotated beliefs come and go among 100,000 others.
n(100).
!start.
+!start : n(N) <- !fill(100000); !churn(N).
+!fill(0).
+!fill(I) <- +item(I, old)[weight(I)]; !fill(I-1).
+!churn(0).
+!churn(I) <- +item(I, new)[weight(I)]; -item(I, new)[weight(I)]; !churn(I-1).
