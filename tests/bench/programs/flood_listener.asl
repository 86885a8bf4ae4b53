+!hear(_).
