// SPDX-License-Identifier: Apache-2.0
package jaywalk;

import java.io.BufferedReader;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Answers the questions of the environment protocol (docs/reference/environment_protocol.md), one
 * line each.
 */
public final class Host {
  /** A tick with actions waits so long for their results; slower actions are under way. */
  private static final long ACTION_PATIENCE_MS = 10;
  /** Environments may change without telling: how often to look at what is perceived. */
  private static final long LOOK_MS = 50;
  private static final long GOODBYE_MS = 500;

  private final Jason jason;
  private final String[] environment; // its class and parameters; empty: none
  private final PrintStream answers;
  private World world;
  private Shadows shadows;
  private final Output output = new Output(this::wake);
  private final Ending ending = new Ending();
  private double number = 0;

  private Host(ClassLoader loader, String[] environment) {
    jason = new Jason(loader);
    this.environment = environment;
    answers =
        new PrintStream(new FileOutputStream(FileDescriptor.out), false, StandardCharsets.UTF_8);
  }

  public static void run(ClassLoader loader, String[] environment) throws IOException {
    new Host(loader, environment).answerAll();
  }

  private void answerAll() throws IOException {
    output.divert();
    Runtime.getRuntime().addShutdownHook(new Thread(() -> ending.begin(this::explainExit)));
    BufferedReader questions =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (String line = questions.readLine(); line != null; line = questions.readLine()) {
      Map<String, Object> question = Json.object(line);
      number = (Double) question.getOrDefault("n", 0.0);
      if ("bye".equals(question.get("type")))
        break;
      ending.asked();
      Map<String, Object> answer;
      try {
        answer = answerTo(question);
      } catch (Throwable thrown) {
        answer = new LinkedHashMap<>();
        answer.put("error", refusal(thrown));
      }
      if (ending.answered())
        send(answer);
    }
    sayGoodbye();
  }

  private synchronized void send(Map<String, Object> answer) {
    answer.put("n", (long) number);
    answers.println(Json.text(answer));
    answers.flush();
  }

  private void wake() {
    if (world != null)
      world.signal();
  }

  private Map<String, Object> answerTo(Map<String, Object> question) throws Throwable {
    switch ((String) question.get("type")) {
      case "hello":
        return hello();
      case "init":
        world.setAgents(names(question));
        if (environment.length > 0)
          world.open(environment[0], Arrays.copyOfRange(environment, 1, environment.length));
        return state();
      case "agents":
        world.setAgents(names(question));
        return state();
      case "tick":
        return tick(question);
      case "call":
        return shadows.call(question);
      case "function":
        return shadows.function(question);
      case "more":
        return shadows.more(question);
      default:
        throw new IllegalArgumentException("unknown question '" + question.get("type") + "'");
    }
  }

  private Map<String, Object> hello() throws Throwable {
    // A class that is not there, or wrong, is wrong before any agent runs.
    if (environment.length > 0)
      jason.type(environment[0]);
    world = new World(jason);
    shadows = new Shadows(jason);
    Map<String, Object> answer = new LinkedHashMap<>();
    answer.put("protocol", 1);
    answer.put("name", "jason");
    answer.put("version", System.getProperty("java.version"));
    answer.put("free_running", true);
    answer.put("tick_ms", 10);
    return answer;
  }

  @SuppressWarnings("unchecked")
  private static Collection<String> names(Map<String, Object> question) {
    return (Collection<String>) question.get("agents");
  }

  private Map<String, Object> tick(Map<String, Object> question) throws Throwable {
    List<?> actions = (List<?>) question.getOrDefault("actions", List.of());
    for (Object each : actions) {
      Map<?, ?> action = (Map<?, ?>) each;
      world.act(((Double) action.get("id")).longValue(), (String) action.get("agent"),
          (String) action.get("action"));
    }
    if (!actions.isEmpty())
      world.waitForResults(ACTION_PATIENCE_MS);
    Map<String, Object> answer = state();
    long end = System.nanoTime() + (long) ((Double) question.getOrDefault("wait_ms", 0.0) * 1e6);
    while (answer.isEmpty()) {
      long left = (end - System.nanoTime()) / 1_000_000;
      if (left <= 0)
        break;
      world.waitForNews(Math.min(left, LOOK_MS));
      answer = state();
    }
    if (answer.isEmpty() && Boolean.TRUE.equals(question.get("idle")) && !world.isActing()
        && !shadows.areWaiting() && Bystanders.none()) {
      answer.put("finished", true);
    }
    return answer;
  }

  /** All that has changed; empty: nothing. */
  private Map<String, Object> state() throws Throwable {
    Map<String, Object> answer = new LinkedHashMap<>();
    // Results first: what an action changes is perceived with its result.
    List<Map<String, Object>> done = world.takeResults();
    Map<String, List<String>> percepts = world.changedPercepts();
    if (!percepts.isEmpty())
      answer.put("percepts", percepts);
    if (!done.isEmpty())
      answer.put("done", done);
    shadows.addNews(answer);
    String text = output.take();
    if (!text.isEmpty())
      answer.put("text", text);
    if (world.isFinished()) {
      answer.put("finished", true);
      if (world.exitValue() != 0)
        answer.put(
            "error", "the environment stopped the system with exit value " + world.exitValue());
    }
    return answer;
  }

  private static String refusal(Throwable thrown) {
    if (thrown instanceof ClassNotFoundException) {
      return "there is no class " + thrown.getMessage()
          + ", nor a source of it, in the project's folder or its class path";
    }
    // Launch's own words for the user, or an exception of the project's.
    if (thrown.getClass().getName().equals("Launch$Refusal"))
      return thrown.getMessage();
    Throwable cause = thrown instanceof ExceptionInInitializerError && thrown.getCause() != null
        ? thrown.getCause()
        : thrown;
    cause.printStackTrace();
    return Jason.described(cause);
  }

  /** Somebody else ends the virtual machine: says so, in answer to a question. */
  private void explainExit(String who) {
    Map<String, Object> answer = new LinkedHashMap<>();
    String text = output.take();
    if (!text.isEmpty())
      answer.put("text", text);
    if (who == null) {
      answer.put("finished", true); // its window was closed
    } else {
      answer.put("error", "the Java code ended its virtual machine: " + who);
    }
    send(answer);
  }

  private void sayGoodbye() {
    Thread closing = new Thread(() -> {
      try {
        if (world != null)
          world.close();
      } catch (Throwable thrown) {
        thrown.printStackTrace();
      }
    });
    closing.setDaemon(true);
    closing.start();
    try {
      closing.join(GOODBYE_MS);
    } catch (InterruptedException now) {
      Thread.currentThread().interrupt();
    }
    // Threads that are no daemons, and hooks, do not keep it alive.
    Runtime.getRuntime().halt(0);
  }
}
