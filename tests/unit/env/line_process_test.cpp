#include "env/process/line_process.h"

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using std::chrono::milliseconds;

TEST(LineProcess, AnswersEachLineWithOne) {
  LineProcess process({"sh", "-c", "while read line; do echo \"<$line>\"; done"});
  EXPECT_EQ(process.ask("one", milliseconds(5000)).line, "<one>");
  EXPECT_EQ(process.ask("two words", milliseconds(5000)).line, "<two words>");
}

TEST(LineProcess, SaysThatAProgramDoesNotExist) {
  LineProcess process({"no_such_program_anywhere"});
  EXPECT_NE(process.ask("x", milliseconds(5000)).error.find("no_such_program_anywhere"),
            std::string::npos);
}

TEST(LineProcess, SaysHowItsProcessEnded) {
  LineProcess process({"sh", "-c", "read line; exit 3"});
  EXPECT_EQ(process.ask("x", milliseconds(5000)).error,
            "'sh' ended without an answer (exit status 3)");
}

TEST(LineProcess, DoesNotWaitForEverAndStartsAnew) {
  LineProcess process({"sh", "-c", "read line; [ $line = wait ] && sleep 60; echo done"});
  EXPECT_EQ(process.ask("wait", milliseconds(50)).error.substr(0, 27),
            "'sh' took too long to answe");
  EXPECT_EQ(process.ask("go", milliseconds(5000)).line, "done");
}

TEST(LineProcess, SurvivesAProcessThatDoesNotRead) {
  LineProcess process({"true"});
  EXPECT_FALSE(process.ask(std::string(1'000'000, 'x'), milliseconds(5000)).error.empty());
}

}  // namespace
}  // namespace jaywalk
