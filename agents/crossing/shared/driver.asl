// A careful and competent human driver (UN Regulation No. 157) as a pedestrian imagines it that
// watches the AV: where that driver would be now instead of the AV, and where it would stop. Metres,
// seconds; time 0 is when the test begins. A pedestrian that steps out while avoids/1 holds could be
// avoided by that driver. Post !watch once a tick.

{ include("metres.asl") }

perception(0.4).      // s, from when a body is over the lane ahead until that is perceived
braking_delay(0.75).  // s, from then until braking begins
jerk(12.65).          // m/s3, with which the deceleration grows
strongest(7.5903).    // m/s2, 0.774 g
acceleration(2).      // m/s2, when the lane is free again
margin(0.1).          // m, for errors of the watching pedestrian

now(S) :- tick(T) & tick_length(L) & S = (T - 1) * L.

// av_seen(Front, Speed, Change): the AV's leading edge, its speed, and the change of speed in a tick.
// av(Y) is a whole cell; the place within the cell follows from watching the speed.
speed_seen(V) :- av_speed(Cells) & cell_length(C) & tick_length(L) & V = Cells * C / L.
front_seen(F, F) :- not av_seen(_, _, _) & av(Y) & cell_length(C) & F = (Y + 1) * C.
moves_off :- av_seen(_, V, Change) & Change > 0.01 & V > 0.
slows     :- av_seen(_, _, Change) & Change < -0.01.
stands    :- av_seen(_, V, _) & V < 0.2.

front_now(F) :-
  av_seen(Old, V0, _) & speed_seen(V) & tick_length(L) & av(Y) & cell_length(C) &
  F = math.max((Y + 1) * C, math.min((Y + 2) * C, Old + (V0 + V) / 2 * L)).

+!watch : watched(T) & tick(T).
+!watch : not av_seen(_, _, _) & av(Y) & cell_length(C) & speed_seen(V)
  <- +cruise(V);
     +risks([]);
     +driver((Y + 1) * C, V, 0);
     +av_seen((Y + 1) * C, V, 0);
     !note_tick.
+!watch
  : driver(F, V, B) & front_now(Av) & speed_seen(Speed) & av_seen(_, Before, _) & risks(Old) &
    .findall(R, risk(F, Old, R), Risks) & tick_length(L) & now(S) & since(Risks, Since) &
    drives(S - L, L, state(F, V, B), Since, state(F1, V1, B1))
  <- -+risks(Risks);
     -+driver(F1, V1, B1);
     -+av_seen(Av, Speed, Speed - Before);
     !note_tick.
+!note_tick : tick(T) <- -+watched(T).

// risk(Who, Since): a pedestrian over the lane ahead of the driver, and since when it is there.
risk(F, Old, risk(Who, Since)) :-
  in_sight(Who, X, Y) & Y >= F - 0.01 & av_lane(From, To) & over(X, From, To) &
  not hidden(F, X, Y) & begun(Who, Old, Since).
begun(Who, Old, Since) :- .member(risk(Who, Since), Old).
begun(Who, Old, Since) :-
  not .member(risk(Who, _), Old) & now(S) & tick_length(L) & Since = S - L.

in_sight(me, X, Y) :- x(X) & near(Y).
in_sight(Id, X, Y) :-
  road_user(Id, pedestrian, Row, Cell, _, _) & cell_length(C) & body(B) &  // jaywalk: allow absent-percept
  X = (Row + 0.5) * C & Y = (Cell + 0.5) * C - B / 2.

// A parked car is between the middle of the pedestrian and the middle of the driver's front.
hidden(F, X, Near) :-
  parked_car(Left, Right, From, To) & F < From & body(B) & Y = Near + B / 2 & Y > From &
  on_line(F, X, Y, From, A) & on_line(F, X, Y, math.min(To, Y), C) & math.max(A, C) > Left &
  math.min(A, C) < Right.
on_line(F, X, Y, At, Where) :- eye(Eye) & Where = Eye + (X - Eye) * (At - F) / (Y - F).
eye(X) :- path(From, To) & X = (From + To) / 2.

parked_car(Left, Right, From, To) :-  // Where nothing is parked nothing hides. jaywalk: allow absent-percept
  obstacle(First, Last, Begin, End) & in_metres(First, Last, Left, Right) &
  in_metres(Begin, End, From, To).
parked(left, From, To)  :- parked_car(_, Right, From, To) & eye(Eye) & Right <= Eye.
parked(right, From, To) :- parked_car(Left, _, From, To) & eye(Eye) & Left >= Eye.

// The place across the road at which a pedestrian comes out from behind a parked car, for the driver.
emerges(left, X) :-
  driver(F, _, _) & y(Y) & parked_car(_, Right, From, To) & F < From & Y > To & eye(Eye) &
  Right <= Eye & X = Eye + (Right - Eye) * (Y - F) / (To - F).
emerges(right, X) :-
  driver(F, _, _) & y(Y) & parked_car(Left, _, From, To) & F < From & Y > To & eye(Eye) &
  Left >= Eye & X = Eye + (Left - Eye) * (Y - F) / (To - F).
emerges(left, -1000) :- not emerges_from(left).
emerges(right, 1000) :- not emerges_from(right).
emerges_from(Side) :- driver(F, _, _) & y(Y) & parked(Side, From, To) & F < From & Y > To.

since(Risks, S) :- .findall(Since, .member(risk(_, Since), Risks), All) & .min([1000000|All], S).

// The driver's state(Front, Speed, Braking) after Left seconds from time S, in steps of 0.05 s.
drives(_, Left, State, _, State) :- Left < 0.0001.
drives(S, Left, state(F, V, B), Since, End) :-
  Left >= 0.0001 & P = math.min(0.05, Left) & perception(Sees) & braking_delay(Delay) &
  Free = math.max(0, math.min(P, Since + Sees + Delay - S)) &
  gains(S, Since + Sees, V, Free, Gain) & kept(Free, B, B0) & presses(B0, P - Free, B1, Loss) &
  cruise(Most) & V1 = math.max(0, math.min(Most, V + Gain - Loss)) &
  drives(S + P, Left - P, state(F + (V + V1) / 2 * P, V1, B1), Since, End).

gains(S, Perceived, V, Free, Gain) :-
  S + 0.000001 < Perceived & acceleration(A) & cruise(Most) & Gain = math.min(A * Free, Most - V).
gains(S, Perceived, _, _, 0) :- S + 0.000001 >= Perceived.
kept(Free, _, 0) :- Free > 0.
kept(0, B, B).
presses(B0, Seconds, B1, Loss) :-
  strongest(Most) & jerk(J) & Grows = math.min((Most - B0) / J, Seconds) & B1 = B0 + J * Grows &
  Loss = (B0 + B1) / 2 * Grows + B1 * (Seconds - Grows).

// The driver's way until it stands if a risk begins in In seconds (negative: began that long ago).
way_to_stop(In, Way) :-
  driver(_, V, B) & perception(Sees) & braking_delay(Delay) & cruise(Most) & acceleration(A) &
  Free = math.max(0, In + Sees) & Gains = math.min(Free, (Most - V) / A) & V1 = V + A * Gains &
  Coasts = math.max(0, In + Sees + Delay - Free) & brakes(V1, B, Last) &
  Way = (V + V1) / 2 * Gains + V1 * (Free - Gains + Coasts) + Last.

brakes(V, B, Way) :-
  strongest(Most) & jerk(J) & G = (Most - B) / J & Lost = (B + Most) / 2 * G & V > Lost &
  Way = V * G - B * G * G / 2 - J * G * G * G / 6 + (V - Lost) * (V - Lost) / (2 * Most).
brakes(V, B, Way) :-
  strongest(Most) & jerk(J) & V <= (B + Most) / 2 * (Most - B) / J &
  T = (math.sqrt(B * B + 2 * J * V) - B) / J & Way = V * T - B * T * T / 2 - J * T * T * T / 6.

// The metres that the driver, once it stands, has left beyond the margin if this pedestrian comes over
// the lane in In seconds; negative: the driver cannot avoid it.
spare(In, Short) :-
  risks(Risks) & since(Risks, Since) & now(S) & way_to_stop(math.min(In, Since - S), Way) &
  driver(F, _, _) & near(N) & margin(M) & Short = N - F - Way - M.
avoids(In) :- spare(In, Short) & Short >= 0.
avoids(_) :- driver_gone.
driver_gone :- driver(F, _, _) & av_metres(Length) & far(Y) & F - Length > Y.

av_metres(M) :- av_length(N) & cell_length(C) & M = N * C.

// The AV, if it does not brake, is beside this pedestrian at some time between From and To (seconds).
comes_by(From, To) :-
  av_seen(F, _, _) & drives_on(From, D) & av_metres(Length) & far(Y) & F + D - Length < Y &
  drives_on(To, More) & near(N) & F + More > N.
drives_on(S, Way) :-
  av_seen(_, V, _) & cruise(Most) & acceleration(A) & Gains = math.min(S, (Most - V) / A) &
  Way = V * S + A * Gains * Gains / 2 + A * Gains * (S - Gains).
