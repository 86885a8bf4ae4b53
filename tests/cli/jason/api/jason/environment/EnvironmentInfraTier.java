// SPDX-License-Identifier: Apache-2.0
package jason.environment;

import jason.asSyntax.Structure;
import jason.runtime.RuntimeServices;

public interface EnvironmentInfraTier {
  void informAgsEnvironmentChanged(String... agents);

  RuntimeServices getRuntimeServices();

  boolean isRunning();

  void actionExecuted(String agent, Structure action, boolean success, Object execution);
}
