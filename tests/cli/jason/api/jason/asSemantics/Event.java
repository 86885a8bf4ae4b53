// SPDX-License-Identifier: Apache-2.0
package jason.asSemantics;

public class Event {
  private final String trigger;

  Event(String trigger) {
    this.trigger = trigger;
  }

  public String getTrigger() {
    return trigger;
  }
}
