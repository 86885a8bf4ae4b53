// SPDX-License-Identifier: Apache-2.0
package jason.asSyntax;

public class Structure extends Literal {
  public Structure(String functor) {
    super(functor);
  }
}
