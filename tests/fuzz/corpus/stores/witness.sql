UPDATE assessments SET actor=2147483647, tick=-1, verdict='fail'; UPDATE actors SET actor=actor+1000000, length_m=-1, actions=-5;
