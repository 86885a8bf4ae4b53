// SPDX-License-Identifier: Apache-2.0
package jaywalk;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * JSON as Map, List, String, Double, Boolean and null. What is read comes from Jaywalk and is well
 * formed.
 */
final class Json {
  private final String text;
  private int at = 0;

  private Json(String text) {
    this.text = text;
  }

  @SuppressWarnings("unchecked")
  static Map<String, Object> object(String line) {
    return (Map<String, Object>) new Json(line).value();
  }

  private char next() {
    while (Character.isWhitespace(text.charAt(at))) ++at;
    return text.charAt(at);
  }

  private Object value() {
    switch (next()) {
      case '{':
        return members();
      case '[':
        return elements();
      case '"':
        return string();
      case 't':
        at += 4;
        return true;
      case 'f':
        at += 5;
        return false;
      case 'n':
        at += 4;
        return null;
      default:
        return number();
    }
  }

  private Map<String, Object> members() {
    Map<String, Object> all = new LinkedHashMap<>();
    ++at;
    while (next() != '}') {
      String key = string();
      next();
      ++at; // the colon
      all.put(key, value());
      if (next() == ',')
        ++at;
    }
    ++at;
    return all;
  }

  private List<Object> elements() {
    List<Object> all = new ArrayList<>();
    ++at;
    while (next() != ']') {
      all.add(value());
      if (next() == ',')
        ++at;
    }
    ++at;
    return all;
  }

  private Double number() {
    int from = at;
    while (at < text.length() && "+-.eE0123456789".indexOf(text.charAt(at)) >= 0) ++at;
    return Double.valueOf(text.substring(from, at));
  }

  private String string() {
    StringBuilder content = new StringBuilder();
    next();
    ++at;
    for (char each = text.charAt(at++); each != '"'; each = text.charAt(at++)) {
      content.append(each == '\\' ? escaped() : each);
    }
    return content.toString();
  }

  private char escaped() {
    char kind = text.charAt(at++);
    switch (kind) {
      case 'n':
        return '\n';
      case 't':
        return '\t';
      case 'r':
        return '\r';
      case 'b':
        return '\b';
      case 'f':
        return '\f';
      case 'u':
        at += 4;
        return (char) Integer.parseInt(text.substring(at - 4, at), 16);
      default:
        return kind;
    }
  }

  static String text(Object value) {
    StringBuilder out = new StringBuilder();
    write(value, out);
    return out.toString();
  }

  private static void write(Object value, StringBuilder out) {
    if (value instanceof Map) {
      String separator = "{";
      for (Map.Entry<?, ?> each : ((Map<?, ?>) value).entrySet()) {
        out.append(separator);
        write(each.getKey(), out);
        out.append(':');
        write(each.getValue(), out);
        separator = ",";
      }
      out.append(separator.equals("{") ? "{}" : "}");
    } else if (value instanceof Iterable) {
      out.append('[');
      String separator = "";
      for (Object each : (Iterable<?>) value) {
        out.append(separator);
        write(each, out);
        separator = ",";
      }
      out.append(']');
    } else if (value instanceof String) {
      quote((String) value, out);
    } else {
      out.append(value);
    }
  }

  private static void quote(String content, StringBuilder out) {
    out.append('"');
    for (int i = 0; i < content.length(); ++i) {
      char each = content.charAt(i);
      if (each == '"' || each == '\\') {
        out.append('\\').append(each);
      } else if (each < ' ' || Character.isSurrogate(each)) {
        out.append(String.format("\\u%04x", (int) each));
      } else {
        out.append(each);
      }
    }
    out.append('"');
  }
}
