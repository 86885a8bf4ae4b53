!g. +!g <- .relevant_plans("+!h",L); .length(L,N); .print(N). +!h <- .print(h).
