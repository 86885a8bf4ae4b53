// math.random: from 0 up to 1, or up to the number.
!start.
+!start
  <- X = math.random; if (X >= 0 & X < 1) { .print("below one") }; Y = math.random(10); if (Y >= 0 & Y < 10) { .print("below ten") };
     .print(math.random(0)); .set_random_seed(1); A = math.random; .set_random_seed(1); B = math.random; if (A == B) { .print("repeated") }.
// expect: below one
// expect: below ten
// expect: 0
// expect: repeated
