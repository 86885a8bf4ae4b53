# A world.
