// SPDX-License-Identifier: Apache-2.0
package jason.runtime;

import java.util.Collection;

public interface RuntimeServices {
  Collection<String> getAgentsNames();

  int getAgentsQty();

  void stopMAS(int deadline, boolean stopsMachine, int exitValue) throws Exception;
}
