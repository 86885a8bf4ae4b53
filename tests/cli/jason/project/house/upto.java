// SPDX-License-Identifier: Apache-2.0
package house;

import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.Constant;
import jason.asSyntax.Term;
import java.util.ArrayList;
import java.util.List;

/** house.upto(N, X): X is 1, 2, ... N. */
public class upto extends DefaultInternalAction {
  @Override
  public Object execute(TransitionSystem system, Unifier unifier, Term[] terms) {
    List<Unifier> all = new ArrayList<>();
    for (int i = 1; i <= Integer.parseInt(terms[0].toString()); ++i) {
      Unifier each = unifier.clone();
      each.unifies(terms[1], new Constant(String.valueOf(i)));
      all.add(each);
    }
    return all.iterator();
  }
}
