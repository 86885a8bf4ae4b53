b("ä€😀", é).
	b(1) # tab before.
text("a\qb").
c :- d % e.
/* this comment has no end
