age(tim, 9).
adult(Name) :- age(Name, Years) & Years >= 18.

+!greet <- for (adult(Name)) { .print("hello ", Name) }.
