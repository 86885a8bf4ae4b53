// SPDX-License-Identifier: Apache-2.0
#include "env/process/line_process.h"

#include <array>
#include <csignal>
#include <memory>
#include <sstream>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

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
  LineProcess process(
      {"sh", "-c", "read line; echo first >&2; echo no licence >&2; kill -SEGV $$"});
  EXPECT_EQ(process.ask("x", milliseconds(5000)).error,
            "it died of signal 11; its last words were 'no licence'");
}

TEST(LineProcess, ReadsMoreErrorsThanAPipeHolds) {
  LineProcess process({"sh", "-c", "read l; head -c 300000 /dev/zero >&2; echo done"});
  EXPECT_EQ(process.ask("x", milliseconds(20000)).line, "done");
}

TEST(LineProcess, DoesNotWaitForOneThatWritesErrorsWithoutEnd) {
  LineProcess process({"sh", "-c", "read line; exec yes >&2"});
  EXPECT_EQ(process.ask("x", milliseconds(200)).error, "no answer within 0.2 s");
}

TEST(LineProcess, KeepsWhatItsProcessWroteToStandardError) {
  LineProcess process({"sh", "-c", "echo first >&2; read l; echo $l; read l; echo last >&2"});
  EXPECT_EQ(process.ask("x", milliseconds(5000)).line, "x");
  EXPECT_EQ(process.take_errors(), "first");
  EXPECT_EQ(process.take_errors(), "");
  process.finish();
  EXPECT_EQ(process.take_errors(), "last");
}

TEST(LineProcess, KeepsTheEndOfALongTextOfErrors) {
  LineProcess process({"sh", "-c", "read l; seq 100000 >&2; echo done"});
  EXPECT_EQ(process.ask("x", milliseconds(20000)).line, "done");
  const std::string text = process.take_errors();
  EXPECT_LT(text.size(), 10000U);
  EXPECT_EQ(text.substr(0, 3), "...");
  EXPECT_EQ(text.substr(text.rfind('\n') + 1), "100000");
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
  const pid_t orphan = std::stoi(answer.line);
  pid_t ended = 0;
  // It becomes our child when its parent has ended.
  for (int i = 0; i < 1000 && ended != orphan; ++i) {
    ended = waitpid(orphan, &status, WNOHANG);
    std::this_thread::sleep_for(milliseconds(5));
  }
  ASSERT_EQ(ended, orphan);
  EXPECT_TRUE(WIFSIGNALED(status));
}

/// A program and a process that it starts, which only SIGKILL ends; it answers with both of their
/// numbers.
const std::vector<std::string> kStubborn{
    "sh", "-c",
    "trap '' TERM HUP INT; (trap '' TERM HUP INT; while :; do sleep 0.05; done) & "
    "read line; echo $$ $!; while :; do sleep 0.05; done"};

bool is_alive(pid_t process) {
  while (waitpid(-1, nullptr, WNOHANG) > 0) {
  }
  return kill(process, 0) == 0;
}

bool ends_within(pid_t process, milliseconds limit) {
  const auto deadline = std::chrono::steady_clock::now() + limit;
  while (std::chrono::steady_clock::now() < deadline) {
    if (!is_alive(process)) return true;
    std::this_thread::sleep_for(milliseconds(5));
  }
  return false;
}

TEST(LineProcess, EndsWithUsEvenIfWeAreKilled) {
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // so that orphans do not stay as zombies
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  const pid_t us = fork();
  if (us == 0) {
    LineProcess process(kStubborn);
    LineAnswer answer;
    // A thread that is gone when the process is used, as those of an experiment are.
    std::thread([&] { answer = process.ask("x", milliseconds(5000)); }).join();
    answer.line += '\n';
    (void)!write(ends[1], answer.line.data(), answer.line.size());
    while (true) pause();
  }
  std::array<char, 100> text{};
  ASSERT_GT(read(ends[0], text.data(), text.size() - 1), 0);
  pid_t program = 0;
  pid_t grandchild = 0;
  std::istringstream(text.data()) >> program >> grandchild;
  ASSERT_TRUE(is_alive(program) && is_alive(grandchild));
  kill(us, SIGKILL);
  EXPECT_TRUE(ends_within(program, milliseconds(5000)));
  EXPECT_TRUE(ends_within(grandchild, milliseconds(5000)));
}

TEST(LineProcess, DoesNotEndWithTheThreadThatStartedIt) {
  LineProcess process({"sh", "-c", "while read line; do echo $line; done"});
  std::thread([&] { EXPECT_EQ(process.ask("a", milliseconds(5000)).line, "a"); }).join();
  std::this_thread::sleep_for(milliseconds(50));
  EXPECT_EQ(process.ask("b", milliseconds(5000)).line, "b");
  EXPECT_EQ(process.lines(), 2U) << "the same process";
}

// Several at once: none keeps another's streams open.
TEST(LineProcess, EndsByItselfWhenItsInputCloses) {
  const std::vector<std::string> command{"sh", "-c", "while read line; do echo $line; done"};
  std::vector<std::unique_ptr<LineProcess>> all;
  for (int i = 0; i < 4; ++i) {
    all.push_back(std::make_unique<LineProcess>(command));
    EXPECT_EQ(all.back()->ask("a", milliseconds(5000)).line, "a");
  }
  const auto start = std::chrono::steady_clock::now();
  for (auto& each : all) each.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - start, milliseconds(2000)) << "nobody was killed";
}

TEST(LineProcess, SurvivesAProcessThatDoesNotRead) {
  LineProcess process({"true"});
  EXPECT_FALSE(process.ask(std::string(1'000'000, 'x'), milliseconds(5000)).error.empty());
}

}  // namespace
}  // namespace jaywalk
