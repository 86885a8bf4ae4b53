// SPDX-License-Identifier: Apache-2.0
package jason.asSemantics;

public class IntendedMeans {
  private final Option option;

  public IntendedMeans(Option option, Object trigger) {
    this.option = option;
  }

  public Unifier getUnif() {
    return option.unifier;
  }
}
