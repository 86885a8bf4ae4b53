// SPDX-License-Identifier: Apache-2.0
package jaywalk;

import java.util.Map;
import java.util.function.Consumer;

/**
 * What happens when the project's classes call System.exit: the question that is open, or the next
 * one, is answered with who did.
 */
final class Ending {
  /** How long an exit waits for a question. */
  private static final long PATIENCE_MS = 2000;

  private boolean isOpen = false; // a question has no answer yet
  private boolean isEnding = false;

  synchronized void asked() {
    isOpen = true;
    notifyAll();
    // The answer is that of the thread that ends the machine.
    while (isEnding) park();
  }

  /** False: the answer is no longer wanted. */
  synchronized boolean answered() {
    while (isEnding) park();
    isOpen = false;
    return true;
  }

  private void park() {
    try {
      wait();
    } catch (InterruptedException again) {
      // The machine is ending.
    }
  }

  synchronized void begin(Consumer<String> answer) {
    String who = caller();
    isEnding = true;
    long end = System.nanoTime() + PATIENCE_MS * 1_000_000;
    while (!isOpen) {
      long left = (end - System.nanoTime()) / 1_000_000;
      if (left <= 0)
        return;
      try {
        wait(left);
      } catch (InterruptedException now) {
        return;
      }
    }
    answer.accept(who);
    // Other hooks, which may wait for anything, have no say.
    Runtime.getRuntime().halt(1);
  }

  /**
   * The first caller of System.exit that is not Java's; null: the user closed the window of the
   * program.
   */
  private static String caller() {
    for (Map.Entry<Thread, StackTraceElement[]> each : Thread.getAllStackTraces().entrySet()) {
      boolean exits = false;
      for (StackTraceElement frame : each.getValue()) {
        if (exits && frame.getClassName().startsWith("javax.swing."))
          return null;
        if (exits && !frame.getClassName().startsWith("java."))
          return frame + " called System.exit";
        exits |=
            frame.getMethodName().equals("exit") && frame.getClassName().startsWith("java.lang.");
      }
    }
    return "System.exit, or a signal";
  }
}
