// SPDX-License-Identifier: Apache-2.0
package jason.asSemantics;

public class Intention {
  private boolean isSuspended = false;

  public void push(IntendedMeans means) {}

  public boolean isSuspended() {
    return isSuspended;
  }

  public void setSuspended(boolean suspended) {
    isSuspended = suspended;
  }
}
