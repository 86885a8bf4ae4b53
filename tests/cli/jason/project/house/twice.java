// SPDX-License-Identifier: Apache-2.0
package house;

import jason.asSemantics.TransitionSystem;
import jason.asSyntax.Term;

/** The function house.twice(N). */
public class twice {
  public double evaluate(TransitionSystem system, Term[] terms) {
    return 2 * Double.parseDouble(terms[0].toString());
  }
}
