// SPDX-License-Identifier: Apache-2.0
package jason.asSemantics;

import jason.asSyntax.Literal;
import jason.asSyntax.Term;

public class DefaultInternalAction implements InternalAction {
  @Override
  public Term[] prepareArguments(Literal call, Unifier unifier) {
    return call.getTerms().stream().map(each -> each.capply(unifier)).toArray(Term[] ::new);
  }

  @Override
  public Object execute(TransitionSystem system, Unifier unifier, Term[] terms) throws Exception {
    return false;
  }
}
