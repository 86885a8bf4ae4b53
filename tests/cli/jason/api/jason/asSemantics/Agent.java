// SPDX-License-Identifier: Apache-2.0
package jason.asSemantics;

import jason.bb.BeliefBase;
import jason.infra.local.LocalAgArch;

public class Agent {
  private final BeliefBase beliefs = new BeliefBase();

  public void initAg() {}

  public void setLogger(LocalAgArch architecture) {}

  public BeliefBase getBB() {
    return beliefs;
  }

  public InternalAction getIA(String name) throws Exception {
    return (InternalAction) Class.forName(name).getConstructor().newInstance();
  }
}
