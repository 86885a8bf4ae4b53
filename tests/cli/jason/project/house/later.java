// SPDX-License-Identifier: Apache-2.0
package house;

import jason.asSemantics.Circumstance;
import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.Constant;
import jason.asSyntax.Term;

/**
 * house.later(How, X): the intention waits until another thread makes X 42, or, if How is fail,
 * ends it.
 */
public class later extends DefaultInternalAction {
  @Override
  public Object execute(TransitionSystem system, Unifier unifier, Term[] terms) {
    Circumstance circumstance = system.getC();
    Intention intention = circumstance.getSelectedIntention();
    intention.setSuspended(true);
    circumstance.getPendingIntentions().put("later", intention);
    new Thread(() -> {
      unifier.unifies(terms[1], new Constant("42"));
      system.runAtBeginOfNextCycle(() -> {
        circumstance.getPendingIntentions().remove("later");
        intention.setSuspended(false);
        if (!terms[0].toString().equals("fail"))
          circumstance.getRunningIntentions().add(intention);
      });
    }).start();
    return true;
  }
}
