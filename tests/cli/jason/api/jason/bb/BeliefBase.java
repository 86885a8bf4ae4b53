// SPDX-License-Identifier: Apache-2.0
package jason.bb;

import jason.asSyntax.Literal;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;

public class BeliefBase implements Iterable<Literal> {
  private final List<Literal> all = new ArrayList<>();

  public boolean add(Literal belief) {
    return all.add(belief);
  }

  public void clear() {
    all.clear();
  }

  public int size() {
    return all.size();
  }

  @Override
  public Iterator<Literal> iterator() {
    return all.iterator();
  }
}
