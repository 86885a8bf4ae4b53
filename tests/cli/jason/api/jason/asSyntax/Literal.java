// SPDX-License-Identifier: Apache-2.0
package jason.asSyntax;

import jason.asSemantics.Unifier;
import java.util.ArrayList;
import java.util.List;

public class Literal implements Term {
  private final String functor;
  private final List<Term> terms = new ArrayList<>();

  public Literal(String functor) {
    this.functor = functor;
  }

  /** Arguments are constants, variables and literals without arguments. */
  public static Literal parseLiteral(String text) {
    int open = text.indexOf('(');
    if (open < 0)
      return new Structure(text);
    Literal literal = new Structure(text.substring(0, open));
    for (String each : text.substring(open + 1, text.lastIndexOf(')')).split(","))
      literal.terms.add(parsed(each.trim()));
    return literal;
  }

  static Term parsed(String text) {
    char first = text.charAt(0);
    if (Character.isUpperCase(first) || first == '_')
      return new VarTerm(text);
    return Character.isLowerCase(first) ? new Structure(text) : new Constant(text);
  }

  public String getFunctor() {
    return functor;
  }

  public int getArity() {
    return terms.size();
  }

  public Term getTerm(int index) {
    return terms.get(index);
  }

  public List<Term> getTerms() {
    return terms;
  }

  @Override
  public Term capply(Unifier unifier) {
    Literal applied = new Structure(functor);
    for (Term each : terms) applied.terms.add(each.capply(unifier));
    return applied;
  }

  @Override
  public String toString() {
    String text = terms.toString().replace(", ", ",");
    return terms.isEmpty() ? functor : functor + "(" + text.substring(1, text.length() - 1) + ")";
  }
}
