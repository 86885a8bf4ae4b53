#include "env/process/line_process.h"

#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>

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
            "it ended with exit code 3 before it answered");
}

TEST(LineProcess, DoesNotWaitForEverAndStartsAnew) {
  LineProcess process({"sh", "-c", "read line; [ $line = wait ] && sleep 60; echo done"});
  EXPECT_EQ(process.ask("wait", milliseconds(50)).error, "no answer within 0.05 s");
  EXPECT_EQ(process.ask("go", milliseconds(5000)).line, "done");
}

TEST(LineProcess, QuotesTheLastWordsOfOneThatDied) {
  LineProcess process({"sh", "-c", "read line; echo first >&2; echo no licence >&2; kill -SEGV $$"},
                      {}, LineProcess::Errors::quoted);
  EXPECT_EQ(process.ask("x", milliseconds(5000)).error,
            "it died of signal 11; its last words were 'no licence'");
}

TEST(LineProcess, ReadsMoreErrorsThanAPipeHolds) {
  LineProcess process({"sh", "-c", "read l; head -c 300000 /dev/zero >&2; echo done"}, {},
                      LineProcess::Errors::quoted);
  EXPECT_EQ(process.ask("x", milliseconds(20000)).line, "done");
}

TEST(LineProcess, RunsInItsFolder) {
  LineProcess process({"sh", "-c", "read line; pwd"}, "/");
  EXPECT_EQ(process.ask("x", milliseconds(5000)).line, "/");
}

TEST(LineProcess, EndsWhatItsProcessStarted) {
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // so that the orphan can be waited for
  LineProcess process({"sh", "-c", "sleep 1000 & read line; echo $!; read line"});
  const LineAnswer answer = process.ask("x", milliseconds(5000));
  ASSERT_TRUE(answer.error.empty());
  process.give_up();
  int status = 0;
  ASSERT_EQ(waitpid(std::stoi(answer.line), &status, 0), std::stoi(answer.line));
  EXPECT_TRUE(WIFSIGNALED(status));
}

TEST(LineProcess, SurvivesAProcessThatDoesNotRead) {
  LineProcess process({"true"});
  EXPECT_FALSE(process.ask(std::string(1'000'000, 'x'), milliseconds(5000)).error.empty());
}

}  // namespace
}  // namespace jaywalk
