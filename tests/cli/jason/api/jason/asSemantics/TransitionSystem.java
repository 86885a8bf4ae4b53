// SPDX-License-Identifier: Apache-2.0
package jason.asSemantics;

import jason.infra.local.LocalAgArch;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.logging.Logger;

public class TransitionSystem {
  private final Queue<Runnable> taskForBeginOfCycle = new ConcurrentLinkedQueue<>();
  private final Circumstance circumstance = new Circumstance();
  private final Agent agent;
  private final LocalAgArch architecture;

  public TransitionSystem(
      Agent agent, Circumstance none, Object settings, LocalAgArch architecture) {
    this.agent = agent;
    this.architecture = architecture;
  }

  public void runAtBeginOfNextCycle(Runnable task) {
    taskForBeginOfCycle.add(task);
  }

  public Circumstance getC() {
    return circumstance;
  }

  public Agent getAg() {
    return agent;
  }

  public LocalAgArch getAgArch() {
    return architecture;
  }

  public Logger getLogger() {
    return Logger.getLogger("jason." + architecture.getAgName());
  }
}
