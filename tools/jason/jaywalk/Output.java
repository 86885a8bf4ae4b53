// SPDX-License-Identifier: Apache-2.0
package jaywalk;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;

/**
 * What the project's classes print and log, kept until the next answer: standard output is the
 * protocol's. Log records look as on Jason's console, `[name] message`.
 */
final class Output {
  private final ByteArrayOutputStream kept = new ByteArrayOutputStream();
  private final Runnable onText;

  /** `onText` is called, by any thread, when there is something to take. */
  Output(Runnable onText) {
    this.onText = onText;
  }

  void divert() {
    System.setOut(new PrintStream(new OutputStream() {
      @Override
      public void write(int one) {
        keep(new byte[] {(byte) one}, 0, 1);
      }

      @Override
      public void write(byte[] bytes, int from, int count) {
        keep(bytes, from, count);
      }
    }, true, StandardCharsets.UTF_8));
    Logger root = Logger.getLogger("");
    for (Handler each : root.getHandlers()) root.removeHandler(each);
    Handler console = new Handler() {
      @Override
      public void publish(LogRecord record) {
        byte[] line = formatted(record).getBytes(StandardCharsets.UTF_8);
        keep(line, 0, line.length);
      }

      @Override
      public void flush() {}

      @Override
      public void close() {}
    };
    console.setLevel(Level.INFO);
    root.addHandler(console);
  }

  private static String formatted(LogRecord record) {
    String name = String.valueOf(record.getLoggerName());
    String text =
        "[" + name.substring(name.lastIndexOf('.') + 1) + "] " + record.getMessage() + "\n";
    if (record.getThrown() == null)
      return text;
    StringWriter trace = new StringWriter();
    record.getThrown().printStackTrace(new PrintWriter(trace));
    return text + trace;
  }

  private void keep(byte[] bytes, int from, int count) {
    synchronized (kept) {
      kept.write(bytes, from, count);
    }
    onText.run();
  }

  boolean isEmpty() {
    synchronized (kept) {
      return kept.size() == 0;
    }
  }

  String take() {
    synchronized (kept) {
      String text = kept.toString(StandardCharsets.UTF_8);
      kept.reset();
      return text;
    }
  }
}
