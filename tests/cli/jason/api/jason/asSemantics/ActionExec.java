// SPDX-License-Identifier: Apache-2.0
package jason.asSemantics;

import jason.asSyntax.Literal;

public class ActionExec {
  private final Literal action;

  public ActionExec(Literal action, Intention intention) {
    this.action = action;
  }

  public Literal getActionTerm() {
    return action;
  }
}
