// SPDX-License-Identifier: Apache-2.0
package jason.asSyntax;

import jason.asSemantics.Unifier;

public class VarTerm extends Constant {
  public VarTerm(String name) {
    super(name);
  }

  @Override
  public Term capply(Unifier unifier) {
    Term value = unifier.get(toString());
    return value == null ? this : value;
  }
}
