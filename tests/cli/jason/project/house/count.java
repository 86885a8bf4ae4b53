// SPDX-License-Identifier: Apache-2.0
package house;

import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.Constant;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;

/** house.count(N): how many beliefs the agent has. Gives it the goal counted(N), too. */
public class count extends DefaultInternalAction {
  @Override
  public Object execute(TransitionSystem system, Unifier unifier, Term[] terms) {
    int beliefs = system.getAg().getBB().size();
    system.getLogger().info("counts");
    system.getC().addAchvGoal(Literal.parseLiteral("counted(" + beliefs + ")"), null);
    return unifier.unifies(terms[0], new Constant(String.valueOf(beliefs)));
  }
}
