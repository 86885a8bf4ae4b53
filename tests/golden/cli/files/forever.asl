!again.

+!again <- !again.
