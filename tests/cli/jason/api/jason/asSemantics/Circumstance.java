// SPDX-License-Identifier: Apache-2.0
package jason.asSemantics;

import jason.asSyntax.Literal;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;

public class Circumstance {
  private Intention SI;
  private final Queue<Event> events = new ConcurrentLinkedQueue<>();
  private final Queue<Intention> running = new ConcurrentLinkedQueue<>();
  private final Map<String, Intention> pending = new ConcurrentHashMap<>();

  public Intention getSelectedIntention() {
    return SI;
  }

  public Queue<Event> getEvents() {
    return events;
  }

  public Queue<Intention> getRunningIntentions() {
    return running;
  }

  public Map<String, Intention> getPendingIntentions() {
    return pending;
  }

  public void addAchvGoal(Literal goal, Intention intention) {
    events.add(new Event("+!" + goal));
  }
}
