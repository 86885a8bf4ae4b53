// SPDX-License-Identifier: Apache-2.0
package jason.asSyntax;

/** A plan with one formula. */
public class Plan {
  private final Literal formula;

  Plan(Literal formula) {
    this.formula = formula;
  }

  public Plan getBody() {
    return this;
  }

  public Literal getBodyTerm() {
    return formula;
  }

  public String getTrigger() {
    return "+!";
  }
}
