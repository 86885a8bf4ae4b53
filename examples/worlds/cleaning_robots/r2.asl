// Burns whatever is put before it.

+garbage(r2) <- .print("burning it"); burn(garb).
