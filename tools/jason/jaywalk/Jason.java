// SPDX-License-Identifier: Apache-2.0
package jaywalk;

import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.HashMap;
import java.util.Map;

/**
 * The user's Jason, called by names: its classes are not there when this is compiled, and differ
 * between its versions. What a called method throws is thrown as it is.
 */
final class Jason {
  private final ClassLoader loader;
  private final Map<String, Method> known = new HashMap<>();

  Jason(ClassLoader loader) {
    this.loader = loader;
  }

  /** The first of these classes that there is: newer versions renamed some. */
  Class<?> type(String... names) throws ClassNotFoundException {
    for (int i = 0; i + 1 < names.length; ++i) {
      try {
        return Class.forName(names[i], true, loader);
      } catch (ClassNotFoundException other) {
        // The next name.
      }
    }
    return Class.forName(names[names.length - 1], true, loader);
  }

  Object create(Class<?> type, Object... arguments) throws Throwable {
    for (Constructor<?> each : type.getDeclaredConstructors()) {
      if (!takes(each, arguments))
        continue;
      each.setAccessible(true);
      try {
        return each.newInstance(arguments);
      } catch (InvocationTargetException thrown) {
        throw thrown.getCause();
      }
    }
    throw new NoSuchMethodException(
        type.getName() + " has no constructor for " + arguments.length + " arguments");
  }

  Object call(Object target, String method, Object... arguments) throws Throwable {
    return invoke(target.getClass(), target, method, arguments);
  }

  Object callStatic(Class<?> type, String method, Object... arguments) throws Throwable {
    return invoke(type, null, method, arguments);
  }

  private Object invoke(Class<?> type, Object target, String name, Object... arguments)
      throws Throwable {
    Method method;
    synchronized (known) {
      StringBuilder key = new StringBuilder(type.getName()).append('.').append(name);
      for (Object each : arguments)
        key.append(' ').append(each == null ? "null" : each.getClass().getName());
      method = known.computeIfAbsent(key.toString(), any -> find(type, name, arguments));
    }
    if (method == null)
      throw new NoSuchMethodException(type.getName() + "." + name);
    try {
      return method.invoke(target, arguments);
    } catch (InvocationTargetException thrown) {
      throw thrown.getCause();
    }
  }

  /** Whether a class has the method at all; `arity` -1: with any number of arguments. */
  static boolean has(Class<?> type, String name, int arity) {
    for (Method each : type.getMethods()) {
      if (each.getName().equals(name) && (arity < 0 || each.getParameterCount() == arity))
        return true;
    }
    return false;
  }

  private static Method find(Class<?> type, String name, Object[] arguments) {
    for (Method each : type.getMethods()) {
      if (!each.getName().equals(name) || each.isBridge() || !takes(each, arguments))
        continue;
      each.setAccessible(true); // its class need not be public
      return each;
    }
    return null;
  }

  private static boolean takes(Executable called, Object[] arguments) {
    Class<?>[] types = called.getParameterTypes();
    if (types.length != arguments.length)
      return false;
    for (int i = 0; i < types.length; ++i) {
      if (arguments[i] != null && !types[i].isInstance(arguments[i]) && !types[i].isPrimitive())
        return false;
    }
    return true;
  }

  /** A field that Jason has no method for. */
  static Field field(Class<?> type, String name) throws NoSuchFieldException {
    for (Class<?> each = type; each != null; each = each.getSuperclass()) {
      try {
        Field field = each.getDeclaredField(name);
        field.setAccessible(true);
        return field;
      } catch (NoSuchFieldException above) {
        // It may be the superclass's.
      }
    }
    throw new NoSuchFieldException(type.getName() + "." + name);
  }

  Object implement(Class<?> contract, InvocationHandler body) {
    return Proxy.newProxyInstance(loader, new Class<?>[] {contract}, (proxy, method, arguments) -> {
      if (method.getDeclaringClass() == Object.class) {
        if (method.getName().equals("equals"))
          return proxy == arguments[0];
        return method.getName().equals("hashCode") ? (Object) System.identityHashCode(proxy)
                                                   : "Jaywalk";
      }
      return body.invoke(proxy, method, arguments == null ? new Object[0] : arguments);
    });
  }

  /** `functor(args)` or an atom. */
  Object structure(String text) throws Throwable {
    return callStatic(type("jason.asSyntax.ASSyntax"), "parseStructure", text);
  }

  /**
   * What happened, where in the user's classes: "java.lang.IllegalStateException: full
   * (House.java:12)".
   */
  static String described(Throwable thrown) {
    for (StackTraceElement each : thrown.getStackTrace()) {
      String in = each.getClassName();
      if (in.startsWith("java") || in.startsWith("jdk.") || in.startsWith("sun.")
          || in.startsWith("jason.") || in.startsWith("jaywalk.")) {
        continue;
      }
      return thrown + " (" + each.getFileName() + ":" + each.getLineNumber() + ")";
    }
    return thrown.toString();
  }
}
