// SPDX-License-Identifier: Apache-2.0
package jason.asSemantics;

import jason.asSyntax.Literal;
import jason.asSyntax.Term;

public interface InternalAction {
  Term[] prepareArguments(Literal call, Unifier unifier);

  Object execute(TransitionSystem system, Unifier unifier, Term[] terms) throws Exception;
}
