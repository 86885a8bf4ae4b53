UPDATE observations SET tick=2147483648, actor=99, x=9e999, y=-9e999, speed=1e308 WHERE id%3=0; UPDATE tests SET ticks=2147483647, scenes=-1;
