// SPDX-License-Identifier: Apache-2.0
package jason.environment;

import jason.asSyntax.Literal;
import jason.asSyntax.Structure;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/** As much of Jason's class of this name as the tests of the adapter need, written for them. */
public class Environment {
  protected ExecutorService executor = Executors.newFixedThreadPool(2);
  private final List<Literal> percepts = new ArrayList<>();
  private final Set<String> informed = new HashSet<>();
  private EnvironmentInfraTier tier;

  public void init(String[] parameters) {}

  public void stop() {}

  public void setEnvironmentInfraTier(EnvironmentInfraTier given) {
    tier = given;
  }

  public EnvironmentInfraTier getEnvironmentInfraTier() {
    return tier;
  }

  public synchronized void addPercept(Literal percept) {
    percepts.add(percept);
    informed.clear();
  }

  public synchronized void clearPercepts() {
    percepts.clear();
    informed.clear();
  }

  public void informAgsEnvironmentChanged(String... agents) {
    tier.informAgsEnvironmentChanged(agents);
  }

  /** Null: unchanged since the agent's last look. */
  public synchronized Collection<Literal> getPercepts(String agent) {
    return informed.add(agent) ? new ArrayList<>(percepts) : null;
  }

  public void scheduleAction(String agent, Structure action, Object execution) {
    executor.execute(
        () -> tier.actionExecuted(agent, action, executeAction(agent, action), execution));
  }

  public boolean executeAction(String agent, Structure action) {
    return false;
  }
}
