// SPDX-License-Identifier: Apache-2.0
// Starts a Java virtual machine that hosts the Java classes of a Jason project. `java Launch.java`
// compiles this file alone; the project's classes and the adapter's own (jaywalk/) are compiled in
// memory as they are asked for, so that nothing is written.
//
//   java Launch.java ADAPTER JASON PROJECT_PATH [ENVIRONMENT_CLASS [PARAMETER]...]
//
// ADAPTER: this folder. JASON: the user's Jason, a jar or a folder. PROJECT_PATH: further class
// folders and jars of the project
// (`classpath`). The working folder is the project's.

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.StringWriter;
import java.net.MalformedURLException;
import java.net.URI;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.StandardLocation;
import javax.tools.ToolProvider;

public final class Launch {
  private static final String MARK = "jason/environment/Environment.class";

  public static void main(String[] args) throws Exception {
    try {
      List<File> jason = jasonFiles(new File(args[1]));
      ProjectLoader loader = new ProjectLoader(new File(args[0]), jason, projectFiles(args[2]));
      checkJason(loader, args[1]);
      Thread.currentThread().setContextClassLoader(loader);
      loader.loadClass("jaywalk.Host")
          .getMethod("run", ClassLoader.class, String[].class)
          .invoke(null, loader, Arrays.copyOfRange(args, 3, args.length));
    } catch (Refusal refusal) {
      refuse(refusal.getMessage());
    } catch (NoClassDefFoundError | ClassNotFoundException incomplete) {
      refuse("cannot start the adapter: " + incomplete);
    }
  }

  /** Answers the first question, which is number 0. */
  private static void refuse(String why) {
    String text =
        why.replace("\\", "\\\\").replace("\"", "\\\"").replace("\n", "\\n").replace("\t", " ");
    System.out.println("{\"n\":0,\"error\":\"" + text + "\"}");
    System.out.flush();
    Runtime.getRuntime().halt(1);
  }

  /** The user's mistake, in words for the user. */
  static final class Refusal extends RuntimeException {
    private static final long serialVersionUID = 1;

    Refusal(String why) {
      super(why);
    }
  }

  /** A Jason that was unpacked, built from its sources, or is a single jar. */
  private static List<File> jasonFiles(File place) {
    if (!place.isDirectory())
      return List.of(place);
    List<File> files = new ArrayList<>();
    if (new File(place, MARK).exists())
      files.add(place);
    for (String folder : new String[] {".", "bin", "lib", "libs", "build/libs", "build/bin",
             "jason-cli/build/bin", "jason-cli/build/libs", "jason-interpreter/build/libs"}) {
      addJars(new File(place, folder), files);
    }
    File program = new File(place, "bin/jason"); // Jason 3: a jar behind a few lines for the shell
    if (program.isFile())
      files.add(program);
    return files;
  }

  private static void addJars(File folder, List<File> files) {
    File[] jars = folder.listFiles(
        (in, name) -> name.matches(".*(?<!-sources|-javadoc|gradle-wrapper)\\.jar"));
    if (jars == null)
      return;
    Arrays.sort(jars);
    files.addAll(Arrays.asList(jars));
  }

  /** Where Jason's own build keeps the classes and libraries of a project. */
  private static List<File> projectFiles(String classPath) {
    List<File> files = new ArrayList<>();
    for (String folder : new String[] {".", "bin/classes", "build/classes/java/main", "bin"}) {
      if (new File(folder).isDirectory())
        files.add(new File(folder));
    }
    addJars(new File("lib"), files);
    for (String each : classPath.split(File.pathSeparator)) {
      if (each.isEmpty())
        continue;
      if (each.endsWith("*.jar") || each.endsWith("*")) {
        addJars(new File(each.substring(0, each.lastIndexOf('/') + 1) + "."), files);
      } else {
        files.add(new File(each));
      }
    }
    return files;
  }

  /** Java's own errors for a wrong place or too old a Java are cryptic, and come late. */
  private static void checkJason(ProjectLoader loader, String place) throws IOException {
    URL found = loader.getResource(MARK);
    if (found == null)
      throw new Refusal(
          "there is no Jason in " + place + ": no jar in it has jason.environment.Environment");
    byte[] head = new byte[8];
    try (var stream = found.openStream()) {
      if (stream.readNBytes(head, 0, 8) < 8)
        throw new Refusal("cannot read " + found);
    }
    int needed =
        ((head[6] & 0xFF) << 8 | head[7] & 0xFF) - 44; // a class file of version 52 is Java 8's
    int running = Runtime.version().feature();
    if (needed > running) {
      throw new Refusal("the Jason in " + place + " needs Java " + needed + ", but this is Java "
          + running + " (" + System.getProperty("java.home") + "); set JAVA_HOME to a newer one");
    }
  }
}

/**
 * Finds the classes of Jason, of the project and of the adapter; compiles sources that have no
 * class, or an older one.
 */
final class ProjectLoader extends URLClassLoader {
  private final List<File> files = new ArrayList<>();
  private final List<File> sources = new ArrayList<>();
  private final Map<String, byte[]> compiled = new HashMap<>();

  ProjectLoader(File adapter, List<File> jason, List<File> project) throws MalformedURLException {
    super(new URL[0], ClassLoader.getPlatformClassLoader());
    files.addAll(project);
    files.addAll(jason);
    for (File file : files) addURL(file.toURI().toURL());
    for (String folder :
        new String[] {".", "src/java", "src/env", "src/agt", "src/main/java", "src"}) {
      if (new File(folder).isDirectory())
        sources.add(new File(folder));
    }
    for (File file : project) {
      if (file.isDirectory() && !sources.contains(file))
        sources.add(file);
    }
    sources.add(adapter);
  }

  @Override
  protected Class<?> findClass(String name) throws ClassNotFoundException {
    byte[] code;
    synchronized (compiled) {
      if (!compiled.containsKey(name))
        compileSourceOf(name);
      code = compiled.get(name);
    }
    if (code == null)
      return super.findClass(name);
    return defineClass(name, code, 0, code.length);
  }

  @Override
  public InputStream getResourceAsStream(String name) {
    synchronized (compiled) {
      byte[] code = name.endsWith(".class")
          ? compiled.get(name.substring(0, name.length() - 6).replace('/', '.'))
          : null;
      return code != null ? new ByteArrayInputStream(code) : super.getResourceAsStream(name);
    }
  }

  private void compileSourceOf(String name) {
    String path = name.replace('.', '/');
    for (File folder : sources) {
      File source = new File(folder, path + ".java");
      if (!source.isFile())
        continue;
      URL known = findResource(path + ".class");
      boolean isFresh = known != null && known.getProtocol().equals("file")
          && new File(URI.create(known.toString())).lastModified() >= source.lastModified();
      if (!isFresh)
        compile(source, "UTF-8");
      return;
    }
  }

  private void compile(File source, String encoding) {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    var problems = new DiagnosticCollector<JavaFileObject>();
    var messages = new StringWriter();
    StandardJavaFileManager disk =
        compiler.getStandardFileManager(problems, null, java.nio.charset.Charset.forName(encoding));
    try {
      disk.setLocation(StandardLocation.CLASS_PATH, files);
      disk.setLocation(StandardLocation.SOURCE_PATH, sources);
    } catch (IOException impossible) {
      throw new Launch.Refusal(impossible.toString());
    }
    Memory memory = new Memory(disk);
    var options = List.of("-nowarn", "-proc:none", "-implicit:class", "-Xlint:none");
    boolean ok =
        compiler.getTask(messages, memory, problems, options, null, disk.getJavaFileObjects(source))
            .call();
    List<Diagnostic<? extends JavaFileObject>> errors =
        problems.getDiagnostics()
            .stream()
            .filter(each -> each.getKind() == Diagnostic.Kind.ERROR)
            .collect(Collectors.toList());
    // Old sources are often in the encoding of their authors.
    if (!ok && encoding.equals("UTF-8")
        && errors.stream().anyMatch(each -> each.getCode().contains("illegal.char.for.encoding"))) {
      compile(source, StandardCharsets.ISO_8859_1.name());
      return;
    }
    if (!ok) {
      throw new Launch.Refusal("cannot compile " + source + ":\n"
          + errors.stream().limit(5).map(Object::toString).collect(Collectors.joining("\n")));
    }
    memory.written.forEach((name, bytes) -> compiled.putIfAbsent(name, bytes.toByteArray()));
  }

  /** Takes the compiler's output; reads from disk. */
  private static final class Memory extends ForwardingJavaFileManager<JavaFileManager> {
    final Map<String, ByteArrayOutputStream> written = new HashMap<>();

    Memory(JavaFileManager disk) {
      super(disk);
    }

    @Override
    public JavaFileObject getJavaFileForOutput(
        Location location, String name, JavaFileObject.Kind kind, FileObject sibling) {
      return new SimpleJavaFileObject(
          URI.create("memory:///" + name.replace('.', '/') + kind.extension), kind) {
        @Override
        public OutputStream openOutputStream() {
          return written.computeIfAbsent(name, any -> new ByteArrayOutputStream());
        }
      };
    }
  }
}
