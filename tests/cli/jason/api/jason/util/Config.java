// SPDX-License-Identifier: Apache-2.0
package jason.util;

import java.util.Properties;

public final class Config extends Properties {
  private static final long serialVersionUID = 1;
  private static final Config ONE = new Config();

  public static Config get() {
    return ONE;
  }
}
