// SPDX-License-Identifier: Apache-2.0
#include "interpreter/compile/kqml_plans.h"

namespace jaywalk {

const std::string_view kKqmlPlans = R"asl(
@kqmlReceivedTellStructure[atomic]
+!kqml_received(KQML_Sender, tell, KQML_NS::KQML_Content, _)
   : .literal(KQML_Content) & .ground(KQML_Content) & not .list(KQML_Content) &
     .add_nested_source(KQML_Content, KQML_Sender, CA)
  <- ++KQML_NS::CA.

@kqmlReceivedTellList
+!kqml_received(KQML_Sender, tell, KQML_Content, _) : .list(KQML_Content)
  <- !add_all_kqml_received(KQML_Sender, KQML_Content).

@kqmlReceivedTellList1
+!add_all_kqml_received(_, []).
@kqmlReceivedTellList2
+!add_all_kqml_received(S, [NS::H|T]) : .literal(H) & .ground(H)
  <- .add_nested_source(H, S, CA); ++NS::CA; !add_all_kqml_received(S, T).
@kqmlReceivedTellList3
+!add_all_kqml_received(S, [_|T])
  <- !add_all_kqml_received(S, T).

@kqmlReceivedUnTell[atomic]
+!kqml_received(KQML_Sender, untell, KQML_NS::KQML_Content, _)
   : .add_nested_source(KQML_Content, KQML_Sender, CA)
  <- --KQML_NS::CA.

@kqmlReceivedAchieve
+!kqml_received(KQML_Sender, achieve, KQML_NS::KQML_Content, _)
   : not .list(KQML_Content) & .add_nested_source(KQML_Content, KQML_Sender, CA)
  <- !!KQML_NS::CA.
@kqmlReceivedAchieveList
+!kqml_received(KQML_Sender, achieve, KQML_Content, _) : .list(KQML_Content)
  <- !add_all_kqml_achieve(KQML_Sender, KQML_Content).

@kqmlReceivedAchieveList1
+!add_all_kqml_achieve(_, []).
@kqmlReceivedAchieveList2
+!add_all_kqml_achieve(S, [NS::H|T])
  <- .add_nested_source(H, S, CA); !!NS::CA; !add_all_kqml_achieve(S, T).

@kqmlReceivedUnAchieve[atomic]
+!kqml_received(_, unachieve, KQML_NS::KQML_Content, _)
  <- .drop_desire(KQML_NS::KQML_Content).

@kqmlReceivedAskOne1
+!kqml_received(KQML_Sender, askOne, KQML_NS::KQML_Content, KQML_MsgId)
   : .kqml_answer(KQML_NS::KQML_Content, KQML_NS::Ans)
  <- .send(KQML_Sender, tell, KQML_NS::Ans, KQML_MsgId).
@kqmlReceivedAskOne2
+!kqml_received(KQML_Sender, askOne, KQML_NS::KQML_Content, KQML_MsgId)
  <- .add_nested_source(KQML_Content, KQML_Sender, CA); ?KQML_NS::CA; .remove_source_annot(CA, CA2);
     .send(KQML_Sender, tell, KQML_NS::CA2, KQML_MsgId).
@kqmlReceivedAskOne3
-!kqml_received(KQML_Sender, askOne, KQML_NS::KQML_Content, KQML_MsgId)[error(test_goal_failed)]
  <- .send(KQML_Sender, untell, KQML_NS::KQML_Content, KQML_MsgId).

@kqmlReceivedAskAll
+!kqml_received(KQML_Sender, askAll, KQML_NS::KQML_Content, KQML_MsgId)
  <- .findall(KQML_NS::Ans, .kqml_answer(KQML_NS::KQML_Content, KQML_NS::Ans), List);
     .send(KQML_Sender, tell, List, KQML_MsgId).

@kqmlReceivedTellHow
+!kqml_received(KQML_Sender, tellHow, KQML_Content, _)
  <- .remove_source_annot(KQML_Content, KQML_Plain); .add_plan(KQML_Plain, KQML_Sender).
@kqmlReceivedUnTellHow
+!kqml_received(KQML_Sender, untellHow, KQML_Content, _)
  <- .remove_plan(KQML_Content, KQML_Sender).
@kqmlReceivedAskHow
+!kqml_received(KQML_Sender, askHow, KQML_Content, KQML_MsgId)
  <- .relevant_plans(KQML_Content, Plans); .remove_source_annot(Plans, Plain);
     .send(KQML_Sender, tellHow, Plain, KQML_MsgId).

@kqmlReceivedSignal
+!kqml_received(KQML_Sender, signal, KQML_NS::KQML_Content, _)
   : not .list(KQML_Content) & .add_nested_source(KQML_Content, KQML_Sender, CA)
  <- .signal({+KQML_NS::CA}).

@kqmlError1
-!kqml_received(_, _, _, _)[error(Error), error_msg(Message)]
  <- .print("Communication error -- ", Error, ": ", Message).
)asl";

}  // namespace jaywalk
