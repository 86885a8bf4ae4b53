// SPDX-License-Identifier: Apache-2.0
// The internal action that docs/internals/add_action.md adds works as the page says.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/actions/table/action_traits.h"
#include "interpreter/logic/action_registry.h"
#include <jaywalk/interpreter.h>

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> printed_by(const std::string& text) {
  std::vector<std::string> printed;
  Interpreter interpreter{{.print = [&](std::string_view line) { printed.emplace_back(line); }}};
  const auto program = interpreter.load_text("clamp.asl", text);
  EXPECT_TRUE(program) << program.diagnostics().render();
  interpreter.add_agent("clamp", program.value());
  interpreter.run();
  return printed;
}

TEST(ActionTutorial, HasAnActionThatWorksInContextsAndBodies) {
  EXPECT_THAT(printed_by("!go. +!go : .clamp(7, 0, 5, X) <- .clamp(-1, 0, 5, Y); .print(X, Y)."),
              ElementsAre("[clamp] 50"));
}

TEST(ActionTutorial, HasAnActionThatSaysWhatIsWrong) {
  EXPECT_THAT(printed_by("!go. +!go <- .clamp(7, 5, 0, X). -!go[error_msg(M)] <- .print(M)."),
              ElementsAre(HasSubstr("not less than the second")));
}

TEST(ActionTutorial, HasARowThatIsAllThatReadersOfProgramsNeed) {
  ASSERT_NE(find_action_row(".clamp"), nullptr);
  EXPECT_TRUE(traits_of(".clamp").binds);
  EXPECT_FALSE(traits_of(".clamp").is_far(4));
}

TEST(ActionTutorial, LeavesTheOtherActionsWhereTheyAre) {
  EXPECT_NE(standard_actions().action(".print"), nullptr);
  EXPECT_NE(standard_actions().action(".clamp"), nullptr);
}

}  // namespace
}  // namespace jaywalk
