// SPDX-License-Identifier: Apache-2.0
package jason.infra.local;

public class LocalAgArch {
  private String name;

  public void setAgName(String given) {
    name = given;
  }

  public String getAgName() {
    return name;
  }

  public void setLogger() {}

  public boolean isRunning() {
    return true;
  }
}
