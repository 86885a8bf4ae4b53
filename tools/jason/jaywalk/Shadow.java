// SPDX-License-Identifier: Apache-2.0
package jaywalk;

import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.logging.Level;
import java.util.logging.Logger;

/**
 * An agent as internal actions in Java see it: an agent of Jason's with its name, without plans,
 * whose goals and beliefs are passed on to the agent itself.
 */
final class Shadow {
  private final Jason jason;
  private final ObjectTerms objects;
  private final String name;
  private final Object agent;
  private final Object system; // its TransitionSystem
  private final Object circumstance;
  private final Map<String, Object> functions = new HashMap<>();
  private final List<Call> waiting = new ArrayList<>();
  private Set<String> believed = new LinkedHashSet<>();

  Shadow(Jason jason, ObjectTerms objects, String name) throws Throwable {
    this.jason = jason;
    this.objects = objects;
    this.name = name;
    // Otherwise the mind inspector starts with the first agent.
    Object config = jason.callStatic(jason.type("jason.util.Config"), "get");
    jason.call(config, "setProperty", "startWebMindInspector", "false");
    Object architecture = jason.create(
        jason.type("jason.infra.local.LocalAgArch", "jason.infra.centralised.CentralisedAgArch"));
    jason.call(architecture, "setAgName", name);
    agent = jason.create(jason.type("jason.asSemantics.Agent"));
    system = jason.create(
        jason.type("jason.asSemantics.TransitionSystem"), agent, null, null, architecture);
    jason.call(agent, "initAg");
    jason.call(agent, "setLogger", architecture);
    jason.call(architecture, "setLogger");
    circumstance = jason.call(system, "getC");
  }

  Call begin(String action, List<String> arguments) throws Throwable {
    String text = arguments.isEmpty() ? action : action + "(" + String.join(",", arguments) + ")";
    return new Call(jason, objects, system, jason.call(agent, "getIA", action), text);
  }

  /** The value of a function with these arguments; of one without a number a string. */
  Object value(String function, List<String> arguments) throws Throwable {
    Object instance = functions.get(function);
    if (instance == null) {
      instance = jason.create(jason.type(function));
      functions.put(function, instance);
    }
    Class<?> syntax = jason.type("jason.asSyntax.ASSyntax");
    Object terms = Array.newInstance(jason.type("jason.asSyntax.Term"), arguments.size());
    for (int i = 0; i < arguments.size(); ++i) {
      Array.set(terms, i, jason.callStatic(syntax, "parseTerm", arguments.get(i)));
    }
    double value = (Double) jason.call(instance, "evaluate", system, terms);
    return Double.isFinite(value) ? (Object) value : String.valueOf(value);
  }

  void believe(List<String> beliefs) throws Throwable {
    Object base = jason.call(agent, "getBB");
    jason.call(base, "clear");
    Class<?> literals = jason.type("jason.asSyntax.Literal");
    for (String each : beliefs)
      jason.call(base, "add", jason.callStatic(literals, "parseLiteral", each));
    believed = beliefTexts();
  }

  private Set<String> beliefTexts() throws Throwable {
    Set<String> texts = new LinkedHashSet<>();
    Iterator<?> all = ((Iterable<?>) jason.call(agent, "getBB")).iterator();
    while (all.hasNext()) texts.add(all.next().toString());
    return texts;
  }

  void await(Call call) {
    waiting.add(call);
  }

  boolean isWaiting() {
    return !waiting.isEmpty();
  }

  /**
   * Calls whose intention is no longer suspended: it runs again, or it is gone, since the action
   * failed.
   */
  void finishCalls(List<Map<String, Object>> called) throws Throwable {
    if (waiting.isEmpty())
      return;
    runTasks();
    for (Iterator<Call> each = waiting.iterator(); each.hasNext();) {
      Call call = each.next();
      if (((Map<?, ?>) jason.call(circumstance, "getPendingIntentions"))
              .containsValue(call.intention))
        continue;
      each.remove();
      Map<String, Object> result = new LinkedHashMap<>();
      result.put("call", call.number);
      boolean succeeded =
          ((Queue<?>) jason.call(circumstance, "getRunningIntentions")).remove(call.intention);
      if (succeeded) {
        result.put("args", call.arguments());
      } else {
        result.put("failed", "");
      }
      called.add(result);
    }
  }

  /**
   * What Jason does at the beginning of a cycle: there actions in other threads resume or fail
   * their intention.
   */
  private void runTasks() throws Throwable {
    Logger logger = (Logger) jason.call(system, "getLogger");
    Level level = logger.getLevel();
    logger.setLevel(
        Level.OFF); // the shadow has no plans for a failure, which is the agent's matter
    try {
      Queue<?> tasks = (Queue<?>) Jason.field(system.getClass(), "taskForBeginOfCycle").get(system);
      for (Object task = tasks.poll(); task != null; task = tasks.poll()) ((Runnable) task).run();
    } finally {
      logger.setLevel(level);
    }
  }

  /**
   * The goals and beliefs that this agent was given since the last call: "+!run(1)", "+free(a)".
   */
  @SuppressWarnings("unchecked")
  void addEvents(Map<String, Object> answer) throws Throwable {
    List<String> events = new ArrayList<>();
    Set<String> now = beliefTexts();
    if (!now.equals(believed)) {
      for (String each : now)
        if (!believed.contains(each))
          events.add("+" + each);
      for (String each : believed)
        if (!now.contains(each))
          events.add("-" + each);
      believed = now;
    }
    Queue<Object> queue = (Queue<Object>) jason.call(circumstance, "getEvents");
    for (Object event = queue.poll(); event != null; event = queue.poll()) {
      String trigger = jason.call(event, "getTrigger").toString();
      if (trigger.startsWith("+!") && !trigger.startsWith("+!jaywalk_call"))
        events.add(trigger);
    }
    if (events.isEmpty())
      return;
    ((Map<String, Object>) answer.computeIfAbsent(
         "events", any -> new LinkedHashMap<String, Object>()))
        .put(name, events);
  }
}
