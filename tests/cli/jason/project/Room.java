// SPDX-License-Identifier: Apache-2.0
import jason.asSyntax.Literal;
import jason.asSyntax.Structure;
import jason.environment.Environment;

/** An environment with an action for each thing that may go wrong. */
public class Room extends Environment {
  @Override
  public void init(String[] parameters) {
    addPercept(Literal.parseLiteral("door(" + parameters[0] + ")"));
    System.out.println("noise");
  }

  @Override
  public boolean executeAction(String agent, Structure action) {
    switch (action.getFunctor()) {
      case "refuse":
        return false;
      case "crash":
        throw new IllegalStateException("the door is stuck");
      case "exit":
        System.exit(0);
        return true;
      case "hang":
        sleepForEver();
        return true;
      case "linger": // leaves a thread that would keep the machine alive
        new Thread(Room::sleepForEver).start();
        return true;
      case "stop":
        try {
          getEnvironmentInfraTier().getRuntimeServices().stopMAS(0, true, 0);
        } catch (Exception impossible) {
          throw new IllegalStateException(impossible);
        }
        return true;
      case "doze":
        sleep(300);
        return true;
      default:
        clearPercepts();
        addPercept(Literal.parseLiteral("done(" + action.getFunctor() + "," + agent + ")"));
        return true;
    }
  }

  private static void sleepForEver() {
    while (true) sleep(1000);
  }

  private static void sleep(int ms) {
    try {
      Thread.sleep(ms);
    } catch (InterruptedException goOn) {
      // It is asked to end, and does not.
    }
  }
}
