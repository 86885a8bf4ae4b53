// SPDX-License-Identifier: Apache-2.0
package jaywalk;

import java.util.ArrayList;
import java.util.List;

/**
 * One call of an internal action: in Jason's terms the only formula of the plan of an intention.
 */
final class Call {
  private final Jason jason;
  private final ObjectTerms objects;
  private final Object system; // the shadow's TransitionSystem
  private final Object action; // the internal action
  private final Object literal; // its call in the plan
  private final Object means; // the plan's IntendedMeans
  final Object intention;
  long number;

  Call(Jason jason, ObjectTerms objects, Object system, Object action, String text)
      throws Throwable {
    this.jason = jason;
    this.objects = objects;
    this.system = system;
    this.action = action;
    Class<?> syntax = jason.type("jason.asSyntax.ASSyntax");
    Object plan = jason.callStatic(syntax, "parsePlan", "+!jaywalk_call <- " + text + ".");
    literal = jason.call(jason.call(plan, "getBody"), "getBodyTerm");
    Object option = jason.create(jason.type("jason.asSemantics.Option"), plan,
        jason.create(jason.type("jason.asSemantics.Unifier")));
    means = jason.create(
        jason.type("jason.asSemantics.IntendedMeans"), option, jason.call(plan, "getTrigger"));
    intention = jason.create(jason.type("jason.asSemantics.Intention"));
    jason.call(intention, "push", means);
  }

  Object execute(long call) throws Throwable {
    number = call;
    Object circumstance = jason.call(system, "getC");
    Jason.field(circumstance.getClass(), "SI").set(circumstance, intention);
    Object unifier = jason.call(means, "getUnif");
    Object terms = jason.call(action, "prepareArguments", literal, unifier);
    objects.restore((Object[]) terms);
    return jason.call(action, "execute", system, unifier, terms);
  }

  boolean isSuspended() throws Throwable {
    return (Boolean) jason.call(intention, "isSuspended");
  }

  List<String> arguments() throws Throwable {
    return arguments(jason.call(means, "getUnif"));
  }

  /** The arguments with the values of a unifier; variables without one keep their names. */
  List<String> arguments(Object unifier) throws Throwable {
    List<String> texts = new ArrayList<>();
    for (Object each : (List<?>) jason.call(literal, "getTerms"))
      texts.add(objects.text(jason.call(each, "capply", unifier)));
    return texts;
  }
}
