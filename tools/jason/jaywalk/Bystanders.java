// SPDX-License-Identifier: Apache-2.0
package jaywalk;

import java.awt.GraphicsEnvironment;
import java.awt.Window;
import java.util.Map;

/**
 * Whether the project's classes could change anything without being asked: by a window, or by a
 * thread of theirs.
 */
final class Bystanders {
  private Bystanders() {}

  static boolean none() {
    if (!GraphicsEnvironment.isHeadless()) {
      for (Window each : Window.getWindows()) {
        if (each.isDisplayable())
          return false;
      }
    }
    for (Map.Entry<Thread, StackTraceElement[]> each : Thread.getAllStackTraces().entrySet()) {
      if (isActive(each.getKey(), each.getValue()))
        return false;
    }
    return true;
  }

  private static boolean isActive(Thread thread, StackTraceElement[] stack) {
    if (thread == Thread.currentThread() || stack.length == 0 || thread.getThreadGroup() == null)
      return false;
    String group = thread.getThreadGroup().getName();
    if (group.equals("system") || group.equals("InnocuousThreadGroup"))
      return false; // Java's own
    String name = thread.getName();
    if (name.equals("jaywalk") || name.startsWith("AWT-") || name.startsWith("Java2D")
        || name.equals("DestroyJavaVM"))
      return false;
    boolean waitsForTask = false;
    boolean waitsForTime = false; // there is a task for later
    for (StackTraceElement frame : stack) {
      waitsForTime |= frame.getMethodName().equals("awaitNanos");
      waitsForTask |= frame.getMethodName().equals("getTask")
          && frame.getClassName().equals("java.util.concurrent.ThreadPoolExecutor");
    }
    return !waitsForTask || waitsForTime;
  }
}
