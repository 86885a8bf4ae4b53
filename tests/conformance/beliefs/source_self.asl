// What an agent believes by itself has the source self.
b(1).
!start.
+!start <- +c(2); ?b(1)[source(S)]; ?c(2)[source(T)]; .print(S, " ", T).
// expect: self self
