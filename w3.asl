!g. +!g <- .drop_event("+!h"); .print(a). 
