// SPDX-License-Identifier: Apache-2.0
package jason.asSyntax;

import jason.asSemantics.Unifier;

public interface Term {
  /** With the values of the variables that have some. */
  Term capply(Unifier unifier);
}
