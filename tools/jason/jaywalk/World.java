// SPDX-License-Identifier: Apache-2.0
package jaywalk;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * The project's environment, a jason.environment.Environment, and what Jason's infrastructure is to
 * it. Actions are executed by the environment's own threads, as in Jason; their results arrive when
 * they arrive.
 */
final class World {
  /**
   * How long the next agent's action waits for this one's to be accepted: in Jason each agent has
   * a thread of its own.
   */
  private static final long PATIENCE_MS = 20;

  private final Jason jason;
  private final Object services;
  private Object environment; // null: the project has none
  private boolean isPlain; // scheduleAction is Jason's own
  private final ExecutorService schedulers = Executors.newCachedThreadPool(World::daemon);
  private final ExecutorService queue = Executors.newSingleThreadExecutor(World::daemon);
  private final Map<String, List<String>> perceived = new HashMap<>();

  // Guarded by `this`, which is notified of news.
  private Collection<String> agents = List.of();
  private final Map<Object, Long> underWay = new IdentityHashMap<>();
  private final List<Map<String, Object>> results = new ArrayList<>();
  private boolean hasNews = false;
  private boolean isFinished = false;
  private int exitValue = 0;

  World(Jason jason) throws Throwable {
    this.jason = jason;
    services =
        jason.implement(jason.type("jason.runtime.RuntimeServices"), (proxy, method, arguments) -> {
          switch (method.getName()) {
            case "getAgentsNames":
            case "getAgentsName":
              return agentNames();
            case "getAgentsQty":
              return agentNames().size();
            case "isRunning":
              return !isFinished();
            case "getMASName":
              return "";
            case "stopMAS":
              finish(arguments.length == 3 ? (Integer) arguments[2] : 0);
              return null;
            default:
              throw new UnsupportedOperationException(
                  "Jaywalk has no RuntimeServices." + method.getName());
          }
        });
    try {
      jason.callStatic(jason.type("jason.runtime.RuntimeServicesFactory"), "set", services);
    } catch (ClassNotFoundException older) {
      // Only Jason 3 has it.
    }
  }

  private static Thread daemon(Runnable work) {
    Thread thread = new Thread(work, "jaywalk");
    thread.setDaemon(true);
    return thread;
  }

  void open(String name, String[] parameters) throws Throwable {
    Object tier = jason.implement(
        jason.type("jason.environment.EnvironmentInfraTier"), (proxy, method, arguments) -> {
          switch (method.getName()) {
            case "informAgsEnvironmentChanged":
              signal();
              return null;
            case "getRuntimeServices":
              return services;
            case "isRunning":
              return !isFinished();
            case "actionExecuted":
              done(arguments[3], (Boolean) arguments[2], "");
              return null;
            default:
              throw new UnsupportedOperationException(
                  "Jaywalk has no EnvironmentInfraTier." + method.getName());
          }
        });
    Object opened = jason.create(jason.type(name));
    jason.call(opened, "setEnvironmentInfraTier", tier);
    jason.call(opened, "init", (Object) parameters);
    isPlain = opened.getClass()
                  .getMethod("scheduleAction", String.class, jason.type("jason.asSyntax.Structure"),
                      Object.class)
                  .getDeclaringClass()
                  .getName()
                  .equals("jason.environment.Environment");
    environment = opened;
  }

  synchronized void setAgents(Collection<String> names) {
    agents = names;
    perceived.keySet().retainAll(names);
  }

  private synchronized Collection<String> agentNames() {
    return new LinkedHashSet<>(agents);
  }

  synchronized void signal() {
    hasNews = true;
    notifyAll();
  }

  private synchronized void finish(int value) {
    isFinished = true;
    exitValue = value;
    signal();
  }

  synchronized boolean isFinished() {
    return isFinished;
  }

  synchronized int exitValue() {
    return exitValue;
  }

  void act(long id, String agent, String text) throws Throwable {
    Object action = jason.structure(text);
    // Environments may look into it.
    Object execution = jason.create(jason.type("jason.asSemantics.ActionExec"), action, null);
    synchronized (this) {
      underWay.put(execution, id);
    }
    if (environment == null) {
      done(execution, false, "the project has no environment");
    } else if (isPlain) {
      ((Executor) Jason.field(environment.getClass(), "executor").get(environment))
          .execute(() -> execute(execution, agent, action));
    } else {
      queue.execute(() -> schedule(execution, agent, action));
    }
  }

  private void execute(Object execution, String agent, Object action) {
    try {
      done(execution, (Boolean) jason.call(environment, "executeAction", agent, action), "");
    } catch (Throwable thrown) {
      thrown.printStackTrace();
      done(execution, false, Jason.described(thrown));
    }
  }

  private void schedule(Object execution, String agent, Object action) {
    Future<?> scheduled = schedulers.submit(() -> {
      try {
        jason.call(environment, "scheduleAction", agent, action, execution);
      } catch (Throwable thrown) {
        thrown.printStackTrace();
        done(execution, false, Jason.described(thrown));
      }
    });
    try {
      scheduled.get(PATIENCE_MS, TimeUnit.MILLISECONDS);
    } catch (TimeoutException other) {
      // It is a step that takes its time, or waits for other agents.
    } catch (Exception impossible) {
      throw new IllegalStateException(impossible);
    }
  }

  private synchronized void done(Object execution, boolean success, String reason) {
    Long id = underWay.remove(execution);
    if (id == null)
      return; // told twice
    Map<String, Object> result = new LinkedHashMap<>();
    result.put("id", id);
    if (!success)
      result.put("failed", reason);
    results.add(result);
    signal();
  }

  synchronized List<Map<String, Object>> takeResults() {
    List<Map<String, Object>> taken = new ArrayList<>(results);
    results.clear();
    return taken;
  }

  /** What has changed for whom since the last call. */
  Map<String, List<String>> changedPercepts() {
    Map<String, List<String>> changed = new LinkedHashMap<>();
    if (environment == null)
      return changed;
    for (String agent : agentNames()) {
      try {
        Collection<?> percepts = (Collection<?>) jason.call(environment, "getPercepts", agent);
        if (percepts == null)
          continue;
        List<String> texts = new ArrayList<>();
        for (Object each : percepts) texts.add(each.toString());
        if (!texts.equals(perceived.put(agent, texts)))
          changed.put(agent, texts);
      } catch (Throwable thrown) {
        thrown.printStackTrace();
      }
    }
    return changed;
  }

  /** Until nothing is under way, or the time is over. */
  synchronized void waitForResults(long limitMs) throws InterruptedException {
    long end = System.nanoTime() + limitMs * 1_000_000;
    while (!underWay.isEmpty()) {
      long left = (end - System.nanoTime()) / 1_000_000;
      if (left <= 0)
        return;
      wait(left);
    }
  }

  /** Until there is news, or the time is over. */
  synchronized void waitForNews(long limitMs) throws InterruptedException {
    if (!hasNews && limitMs > 0)
      wait(limitMs);
    hasNews = false;
  }

  synchronized boolean isActing() {
    return !underWay.isEmpty();
  }

  void close() throws Throwable {
    if (environment != null)
      jason.call(environment, "stop");
  }
}
