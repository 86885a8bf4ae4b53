// SPDX-License-Identifier: Apache-2.0
package jaywalk;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Java objects as terms (jason.asSyntax.ObjectTerm). Outside of the virtual machine such a term is
 * a string, the object's text, which is what Jason prints; an internal action that is given an
 * equal string gets the object.
 */
final class ObjectTerms {
  /** Of more objects the one that was not used for the longest time is forgotten. */
  private static final int MOST = 10_000;

  private final Map<String, Object> terms = new LinkedHashMap<>(16, 0.75f, true) {
    private static final long serialVersionUID = 1;

    @Override
    protected boolean removeEldestEntry(Map.Entry<String, Object> eldest) {
      return size() > MOST;
    }
  };

  /** The term as text. */
  String text(Object term) {
    if (!term.getClass().getName().equals("jason.asSyntax.ObjectTermImpl"))
      return term.toString();
    String text = Json.text(term.toString());
    terms.put(text, term);
    return text;
  }

  void restore(Object[] arguments) {
    if (terms.isEmpty())
      return;
    for (int i = 0; i < arguments.length; ++i) {
      arguments[i] = terms.getOrDefault(arguments[i].toString(), arguments[i]);
    }
  }
}
