// SPDX-License-Identifier: Apache-2.0
package jason.asSyntax;

import jason.asSemantics.Unifier;

/** A number, string or list: of meaning by its text alone. */
public class Constant implements Term {
  private final String text;

  public Constant(String text) {
    this.text = text;
  }

  @Override
  public Term capply(Unifier unifier) {
    return this;
  }

  @Override
  public String toString() {
    return text;
  }
}
