// SPDX-License-Identifier: Apache-2.0
package jaywalk;

import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The shadows of the agents, and the calls of internal actions that have more solutions or are not
 * done.
 */
final class Shadows {
  /**
   * A query that found enough does not say so: of more calls than these the oldest is forgotten.
   */
  private static final int MOST_OPEN = 1000;

  private final Jason jason;
  private final ObjectTerms objects = new ObjectTerms();
  private final Map<String, Shadow> all = new LinkedHashMap<>();
  private final Map<String, Boolean> needBeliefs = new HashMap<>();
  private final Map<Long, Solutions> open = new LinkedHashMap<>() {
    private static final long serialVersionUID = 1;

    @Override
    protected boolean removeEldestEntry(Map.Entry<Long, Solutions> eldest) {
      return size() > MOST_OPEN;
    }
  };

  private static final class Solutions {
    final Call call;
    final Iterator<?> unifiers;

    Solutions(Call call, Iterator<?> unifiers) {
      this.call = call;
      this.unifiers = unifiers;
    }
  }

  Shadows(Jason jason) {
    this.jason = jason;
  }

  private Shadow of(String agent) throws Throwable {
    Shadow shadow = all.get(agent);
    if (shadow == null) {
      shadow = new Shadow(jason, objects, agent);
      all.put(agent, shadow);
    }
    return shadow;
  }

  @SuppressWarnings("unchecked")
  Map<String, Object> call(Map<String, Object> question) throws Throwable {
    Map<String, Object> answer = new LinkedHashMap<>();
    String name = (String) question.get("name");
    List<String> beliefs = (List<String>) question.get("beliefs");
    try {
      if (beliefs == null && asksForBeliefs(name)) {
        answer.put("needs", "beliefs");
        return answer;
      }
      Shadow shadow = of((String) question.get("agent"));
      if (beliefs != null)
        shadow.believe(beliefs);
      Call call = shadow.begin(name, (List<String>) question.get("args"));
      long number = ((Double) question.get("n")).longValue();
      Object result = call.execute(number);
      if (result instanceof Iterator) {
        open.put(number, new Solutions(call, (Iterator<?>) result));
        nextSolution(number, answer);
      } else if (!Boolean.TRUE.equals(result)) {
        answer.put("result", false);
      } else if (call.isSuspended()) {
        answer.put("result", "later");
        shadow.await(call);
      } else {
        answer.put("result", true);
        answer.put("args", call.arguments());
      }
      shadow.addEvents(answer);
    } catch (ClassNotFoundException missing) {
      fail(answer, "unknown_internal_action",
          "there is no internal action " + name + ": no class " + missing.getMessage());
    } catch (Throwable thrown) {
      describe(answer, thrown);
    }
    return answer;
  }

  /** The value of a function, which no agent asks for. */
  @SuppressWarnings("unchecked")
  Map<String, Object> function(Map<String, Object> question) throws Throwable {
    Map<String, Object> answer = new LinkedHashMap<>();
    try {
      answer.put("result",
          of("").value((String) question.get("name"), (List<String>) question.get("args")));
    } catch (Throwable thrown) {
      // An expression cannot fail with a reason.
      System.err.println("the function " + question.get("name") + ": " + thrown);
      answer.put("result", null);
    }
    return answer;
  }

  Map<String, Object> more(Map<String, Object> question) throws Throwable {
    Map<String, Object> answer = new LinkedHashMap<>();
    try {
      nextSolution(((Double) question.get("call")).longValue(), answer);
    } catch (Throwable thrown) {
      describe(answer, thrown);
    }
    return answer;
  }

  private void nextSolution(long number, Map<String, Object> answer) throws Throwable {
    Solutions solutions = open.get(number);
    boolean found = solutions != null && solutions.unifiers.hasNext();
    answer.put("result", found);
    if (found) {
      answer.put("args", solutions.call.arguments(solutions.unifiers.next()));
      answer.put("more", number);
    } else {
      open.remove(number);
    }
  }

  /** As Jason's annotations of a failure would be. */
  private void describe(Map<String, Object> answer, Throwable thrown) {
    if (thrown.getClass().getName().equals("Launch$Refusal")) {
      fail(answer, "internal_action", thrown.getMessage());
    } else if (thrown.getClass().getName().startsWith("jason.")) {
      fail(answer, "internal_action", String.valueOf(thrown.getMessage()));
    } else {
      thrown.printStackTrace();
      fail(answer, "internal_action", Jason.described(thrown));
    }
  }

  private static void fail(Map<String, Object> answer, String id, String message) {
    answer.put("result", "error");
    answer.put("id", id);
    answer.put("message", message);
  }

  /**
   * Sending all beliefs costs time, and most internal actions ask for none: whether the class
   * names a method that gets at them.
   */
  private boolean asksForBeliefs(String name) throws Throwable {
    Boolean known = needBeliefs.get(name);
    if (known == null) {
      Class<?> type = jason.type(name);
      known = false;
      try (InputStream code =
               type.getClassLoader().getResourceAsStream(name.replace('.', '/') + ".class")) {
        if (code != null) {
          String constants = new String(code.readAllBytes(), StandardCharsets.ISO_8859_1);
          for (String each : new String[] {"getBB", "findBel", "believes", "logicalConsequence",
                   "addBel", "delBel", "abolish"}) {
            known |= constants.contains(each);
          }
        }
      }
      needBeliefs.put(name, known);
    }
    return known;
  }

  boolean areWaiting() {
    for (Shadow each : all.values()) {
      if (each.isWaiting())
        return true;
    }
    return false;
  }

  /**
   * Calls that are done now, and goals and beliefs that the project's classes gave agents by
   * themselves.
   */
  void addNews(Map<String, Object> answer) throws Throwable {
    List<Map<String, Object>> called = new ArrayList<>();
    for (Shadow each : all.values()) {
      each.finishCalls(called);
      each.addEvents(answer);
    }
    if (!called.isEmpty())
      answer.put("called", called);
  }
}
