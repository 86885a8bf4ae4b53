// SPDX-License-Identifier: Apache-2.0
package jason.asSemantics;

import jason.asSyntax.Term;
import jason.asSyntax.VarTerm;
import java.util.HashMap;
import java.util.Map;

public class Unifier {
  private final Map<String, Term> values = new HashMap<>();

  public Term get(String variable) {
    return values.get(variable);
  }

  public boolean unifies(Term first, Term second) {
    if (!(first instanceof VarTerm))
      return first.toString().equals(second.toString());
    Term value = values.putIfAbsent(first.toString(), second);
    return value == null || value.toString().equals(second.toString());
  }

  @Override
  public Unifier clone() {
    Unifier copy = new Unifier();
    copy.values.putAll(values);
    return copy;
  }
}
