// Meetings with the AV: meeting(Row, Ahead, How) is in a row of its way, Ahead cells ahead of it, walking
// across, along or standing. Which meetings are possible, and how to bring one about.
// jaywalk: asks across/2, free/1, rows_to/4, ticks_to_walk/2, way_across/1, !cross/1, !cross_road/0

// Walk, or wait, until crossing leads to the meeting.
+!meet(Meeting) : slack(Meeting, S) & used_up(S) & Meeting = meeting(Row, _, How) & way_across(Way)
  <- !cross_to(Row);
     !go_on(How);
     !cross(Way).
+!meet(Meeting) : slack(Meeting, S) & step_for(S, Way) <- !step(Way); !meet(Meeting).
+!meet(_) <- !cross_road.

+!step(stay) <- stay.
+!step(Way)  <- move(Way).

+!cross_to(Row) : at(X, _) & walking_speed(W) & math.abs(X - Row) <= W / 2.
+!cross_to(Row) : at(X, _) & X < Row & across(right, Step) <- move(Step); !cross_to(Row).
+!cross_to(Row) : at(X, _) & X > Row & across(left, Step)  <- move(Step); !cross_to(Row).
+!cross_to(_).

+!go_on(across).
+!go_on(along) : free(forward) <- move(forward).
+!go_on(_)                     <- stay.

// Meetings that can still be brought about.
possible(meeting(Row, Ahead, How)) :-
  zone_rows(First, Last) & .range(Row, First, Last) & zone_ahead(From, To) &
  .range(Ahead, From, To) & manner(How, _, _, _) & not met_before(Row, Ahead, How) &
  slack(meeting(Row, Ahead, How), S) & can_use_up(S).

// The pedestrian would be in the zone a tick earlier already, when the AV was V cells further back.
met_before(Row, Ahead, How) :-
  av_speed(V) & zone_ahead(_, To) & Ahead + V <= To & manner(How, _, More, _) & walking_speed(W) &
  rows_in(Row, Rows) & Rows - W * (1 - More) >= -0.5.

// How many rows into the zone a row is, from where the pedestrian comes.
rows_in(Row, N) :- way_across(right) & zone_rows(First, _) & N = Row - First.
rows_in(Row, N) :- way_across(left) & zone_rows(_, Last) & N = Last - Row.

// How to move when the AV comes: the bins of coverage for coming from the left and from the right, the
// ticks needed beyond crossing, and the steps forward.
manner(across, [1, 2], 0, 0).
manner(along, [3, 3], 1, 1).
manner(standing, [4, 4], 1, 0).

// How much nearer the AV must be, in cells, when the pedestrian begins to cross. In a tick the AV
// comes nearer by V cells, by a step W less if the pedestrian walks forward, by W more if it walks back.
slack(meeting(Row, Ahead, How), S) :-
  manner(How, _, More, Steps) & at(X, Y) & av(AvY) & av_speed(V) & walking_speed(W) &
  rows_to(X, Row, Row, N) & ticks_to_walk(N, T) &
  S = Y + Steps * W - AvY - V * (T + More - 1) - Ahead.

// Half a cell either way still hits the intended cell.
used_up(S)    :- S >= -0.5 & S <= 0.5.
can_use_up(S) :- used_up(S).
can_use_up(S) :-
  S > 0.5 & av_speed(V) & walking_speed(W) & S + 0.5 >= math.ceil((S - 0.5) / (V + W)) * (V - W).

step_for(S, stay)    :- av_speed(V) & can_use_up(S - V).
step_for(S, forward) :- free(forward) & av_speed(V) & walking_speed(W) & can_use_up(S - V + W).
step_for(S, back)    :- free(back) & av_speed(V) & walking_speed(W) & can_use_up(S - V - W).
