// SPDX-License-Identifier: Apache-2.0
package jason.asSyntax;

public final class ASSyntax {
  private ASSyntax() {}

  public static Structure parseStructure(String text) {
    return (Structure) Literal.parseLiteral(text);
  }

  public static Term parseTerm(String text) {
    return Literal.parsed(text);
  }

  public static Plan parsePlan(String text) {
    return new Plan(
        Literal.parseLiteral(text.substring(text.indexOf("<-") + 2, text.lastIndexOf('.')).trim()));
  }
}
