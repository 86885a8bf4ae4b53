// SPDX-License-Identifier: Apache-2.0
package jason.asSemantics;

import jason.asSyntax.Plan;

public class Option {
  final Unifier unifier;

  public Option(Plan plan, Unifier unifier) {
    this.unifier = unifier;
  }
}
