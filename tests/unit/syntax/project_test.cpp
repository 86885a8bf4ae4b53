// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/project/project.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

std::optional<Project> project_of(const std::string& text, Diagnostics& diagnostics) {
  return parse_project(std::make_shared<const Source>("p.mas2j", text), diagnostics);
}

TEST(Project, NamesItsAgentsAndTheirFiles) {
  Diagnostics diagnostics;
  const auto project = project_of(
      "// a project\nMAS demo { agents: a; b two; c ./inc/three.asl #3; d [verbose=2]; e x.inc; }",
      diagnostics);
  ASSERT_TRUE(project) << diagnostics.render();
  EXPECT_EQ(project->name, "demo");
  ASSERT_EQ(project->agents.size(), 5U);
  EXPECT_EQ(project->agents[0].file, "");
  EXPECT_EQ(project->agents[1].file, "two.asl");
  EXPECT_EQ(project->agents[2].file, "./inc/three.asl");
  EXPECT_EQ(project->agents[2].count, 3);
  EXPECT_EQ(project->agents[3].name, "d");
  EXPECT_EQ(project->agents[4].file, "x.inc");
}

TEST(Project, KeepsTheOptionsOfAnAgentWithTheirPlaces) {
  Diagnostics diagnostics;
  const auto project = project_of(
      "MAS m { agents: a [beliefs=\"b(1),c(\\\"x\\\")\", events=discard, verbose=1, my=Word]; }",
      diagnostics);
  ASSERT_TRUE(project) << diagnostics.render();
  const auto& options = project->agents[0].options;
  ASSERT_EQ(options.size(), 4U);
  EXPECT_EQ(options[0].name, "beliefs");
  EXPECT_EQ(options[0].value, "b(1),c(\"x\")");
  EXPECT_EQ(project->source->text(options[0].where.span).substr(0, 4), "b(1)");
  EXPECT_EQ(options[1].value, "discard");
  EXPECT_EQ(options[3].value, "Word");
}

TEST(Project, KeepsClassesWithTheirParameters) {
  Diagnostics diagnostics;
  const auto project = project_of(
      "MAS m { infrastructure: Local(pool,4) environment: my.Env(\"a b\",[1,2]) at \"host\"\n"
      "executionControl: jason.control.ExecutionControl\n"
      "agents: a agentArchClass x.Arch agentClass x.Ag beliefBaseClass "
      "jason.bb.IndexedBB(\"s(_)\") "
      "at \"h\";\ndirectives: d = x.Dir; classpath: \"a.jar\"; aslSourcePath: \"src\"; \"lib\"; }",
      diagnostics);
  ASSERT_TRUE(project) << diagnostics.render();
  EXPECT_EQ(project->infrastructure->name, "Local");
  EXPECT_EQ(project->infrastructure->parameters, (std::vector<std::string>{"pool", "4"}));
  EXPECT_EQ(project->environment->name, "my.Env");
  EXPECT_EQ(project->environment->parameters, (std::vector<std::string>{"\"a b\"", "[1,2]"}));
  EXPECT_EQ(project->source->text(project->environment->where.span), "my.Env(\"a b\",[1,2])");
  EXPECT_EQ(project->execution_control->name, "jason.control.ExecutionControl");
  EXPECT_EQ(project->agents[0].arch_class->name, "x.Arch");
  EXPECT_EQ(project->agents[0].agent_class->name, "x.Ag");
  EXPECT_EQ(project->agents[0].belief_base_class->parameters,
            (std::vector<std::string>{"\"s(_)\""}));
  EXPECT_EQ(project->agents[0].at, "h");
  ASSERT_EQ(project->directives.size(), 1U);
  EXPECT_EQ(project->directives[0].second.name, "x.Dir");
  EXPECT_EQ(project->class_path, (std::vector<std::string>{"a.jar"}));
  EXPECT_EQ(project->asl_source_path, (std::vector<std::string>{"src", "lib"}));
}

TEST(Project, ReadsNumbersOfAllKinds) {
  Diagnostics diagnostics;
  const auto project = project_of("MAS m { environment: E(1, 2.5, .5, 1e3, 2.5E-7) }", diagnostics);
  ASSERT_TRUE(project) << diagnostics.render();
  EXPECT_EQ(project->environment->parameters,
            (std::vector<std::string>{"1", "2.5", ".5", "1e3", "2.5E-7"}));
}

TEST(Project, EndsWithItsBraceWhateverFollows) {
  Diagnostics diagnostics;
  EXPECT_TRUE(project_of("MAS m { agents: a; } // b\n\nto do: \\ % \"", diagnostics));
  EXPECT_FALSE(diagnostics.has_errors());
  ASSERT_EQ(diagnostics.items().size(), 1U);
  EXPECT_EQ(diagnostics.items().front().message, "what stands behind the project is left out");
}

TEST(Project, SaysWhatIsWrong) {
  struct Row {
    const char* text;
    const char* message;
    const char* hint;
  };
  for (const auto& [text, message, hint] : {
           Row{"", "expected 'MAS', found the end of the text",
               "a project begins with MAS and its name"},
           Row{"MAS m { agent: a; }", "expected a section such as 'agents', found 'agent'",
               "did you mean 'agents'?"},
           Row{"MAS m { agents: a }", "expected ';', found '}'", ""},
           Row{"MAS m { agents: at; }", "expected the name of an agent, found 'at'",
               "'at' is a reserved word"},
           Row{"MAS m { agents: Bob; }", "expected the name of an agent, found 'Bob'",
               "names begin with a lower-case letter"},
           Row{"MAS m { agents: a inc/a.asl; }", "expected '.asl', '[' or ';', found '/'",
               "a file in a folder is written './inc...'"},
           Row{"MAS m { agents: a #0; }", "'0' is not a number of agents", ""},
           Row{"MAS m { agents: a [events=discrad]; }", "the option 'events' cannot be 'discrad'",
               "did you mean 'discard'?"},
           Row{"MAS m { agents: a [verbose=loud]; }",
               "the option 'verbose' must be a number, not 'loud'", ""},
           Row{"MAS m { agents: a agentclass x.Y; }", "expected ';', found 'x'",
               "did you mean 'agentClass'?"},
           Row{"MAS m { agents: a; environment: x }",
               "the section 'environment' must stand before 'agents'", ""},
           Row{"MAS m { agents: a;", "expected '}', found the end of the text", ""},
           Row{"MAS m { aslSourcePath: \"x; }", "this string is not closed on its line", ""},
       }) {
    Diagnostics diagnostics;
    EXPECT_FALSE(project_of(text, diagnostics)) << text;
    ASSERT_TRUE(diagnostics.has_errors()) << text;
    EXPECT_EQ(diagnostics.items().front().message, message) << text;
    EXPECT_EQ(diagnostics.items().front().hint, hint) << text;
  }
}

TEST(Project, TellsSeveralErrors) {
  Diagnostics diagnostics;
  EXPECT_FALSE(project_of("MAS m { agents: a #; b; c [; d; }", diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 2U) << diagnostics.render();
}

TEST(Project, HasAMillionAgentsAtMost) {
  for (const auto& [agents, is_refused] :
       {std::pair{"a #1000000;", false}, std::pair{"a #1000001;", true},
        std::pair{"a #600000; b #600000;", true},
        std::pair{"a #2000000000; b #2000000000;", true}}) {
    Diagnostics diagnostics;
    (void)project_of(std::string("MAS m { agents: ") + agents + " }", diagnostics);
    EXPECT_EQ(diagnostics.has_errors(), is_refused) << agents;
    if (is_refused) {
      EXPECT_NE(diagnostics.render().find("more than 1000000"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace jaywalk
