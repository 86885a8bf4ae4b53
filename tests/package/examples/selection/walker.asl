!stroll.
!talk.
car(near).

@stroll +!stroll <- .print("one step"); .print("another step"); .print("a third step").
@talk +!talk <- .print("hello"); .print("goodbye").
@look +car(near) <- .print("a car").
@jump[priority(5)] +car(near) <- .print("a car!"); .print("back to the pavement").
