!g. +!g <- .at("now +1 s","+!h"). +!h <- .print(h).
