// SPDX-License-Identifier: Apache-2.0
// A program that says more than it was asked, or answers something else, is found out, so that no
// answer is taken for another question's.

#include "env/process/numbered_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

/// Asks a shell script questions 0, 1, 2… under the key `n`; it answers how many lines it has read.
class Numbered : public testing::Test {
 protected:
  void start(const std::string& script, milliseconds settling = milliseconds(500)) {
    process_ = std::make_unique<NumberedProcess>(NumberedProcess::Settings{
        .command = {"sh", "-c", "i=-1; while read line; do i=$((i+1)); " + script + "; done"},
        .key = "n",
        .settling = settling});
  }
  JsonAnswer ask() { return process_->ask({{"x", 1}}, number_++, milliseconds(5000)); }

  std::unique_ptr<NumberedProcess> process_;
  std::size_t number_ = 0;
};

constexpr auto kPlain = R"(echo "{\"v\": $i}")";
constexpr auto kRepeating = R"(echo "{\"n\": $i, \"v\": $i}")";

TEST_F(Numbered, GetsTheAnswerToEachQuestion) {
  start(R"(echo "{\"heard\": $line}")", milliseconds(10));
  const JsonAnswer answer = ask();
  EXPECT_EQ(answer.error, "");
  EXPECT_EQ(answer.json["heard"]["n"], 0);
  EXPECT_EQ(answer.json["heard"]["x"], 1);
  EXPECT_EQ(ask().json["heard"]["n"], 1);
}

TEST_F(Numbered, RefusesALineTooManyInTheQuestionThatItCameAfter) {
  start(std::string(kPlain) + "; [ $i = 1 ] && " + kPlain);
  EXPECT_EQ(ask().json["v"], 0);
  const JsonAnswer second = ask();
  EXPECT_EQ(second.error,
            "line 2 of its output, '{\"v\": 1}': one line is an answer, but it also wrote "
            "'{\"v\": 1}'");
  EXPECT_FALSE(second.silent);
  EXPECT_EQ(ask().json["v"], 0) << "a new process";
}

TEST_F(Numbered, RefusesALineTooManyThatRepeatsTheNumber) {
  start(R"(printf '{"n": %d}\n{"n": %d}\n' $i $i)");
  EXPECT_THAT(ask().error, HasSubstr("but it also wrote '{\"n\": 0}'"));
}

TEST_F(Numbered, LooksForLinesAfterTheLastAnswer) {
  start(std::string(kRepeating) + "; sleep 0.05; echo more");
  EXPECT_EQ(ask().error, "");
  EXPECT_THAT(process_->said_more(milliseconds(5000)), HasSubstr("but it also wrote 'more'"));
  EXPECT_EQ(process_->said_more(milliseconds(0)), "") << "it is gone";
}

TEST_F(Numbered, RefusesNumbersThatJsonDoesNotHave) {
  for (const char* number : {"1e999", "inf", "NaN", "-Infinity", "1e99999999999"}) {
    start(std::string("echo '{\"v\": ") + number + "}'");
    EXPECT_THAT(ask().error, HasSubstr("expected a JSON object")) << number;
  }
}

// The line comes when the next question has been asked already.
TEST_F(Numbered, FindsALateLineTooManyByTheNumber) {
  start(std::string(R"(if [ $i = 2 ]; then echo '{"n": 1, "v": 1}'; fi; )") + kRepeating);
  EXPECT_EQ(ask().json["v"], 0);
  EXPECT_EQ(ask().json["v"], 1);
  EXPECT_THAT(ask().error, HasSubstr("it answers n 1, expected 2"));
}

TEST_F(Numbered, AnswersManyQuestionsThatAreAskedAtOnce) {
  start(kRepeating);
  EXPECT_EQ(ask().json["v"], 0);
  const std::vector<std::string> questions(300, R"({"x": 1})");
  const std::vector<JsonAnswer> answers = process_->ask_texts(questions, 1, milliseconds(20000));
  ASSERT_EQ(answers.size(), 300U);
  EXPECT_EQ(answers[0].json["v"], 1);
  EXPECT_EQ(answers[299].error, "");
  EXPECT_EQ(answers[299].json["v"], 300);
}

TEST_F(Numbered, AsksOneByOneWhereNoNumberIsRepeated) {
  start(std::string(kPlain) + "; [ $i = 2 ] && " + kPlain, milliseconds(200));
  const std::vector<std::string> questions(5, R"({"x": 1})");
  const std::vector<JsonAnswer> answers = process_->ask_texts(questions, 0, milliseconds(5000));
  ASSERT_EQ(answers.size(), 3U) << "up to the first error";
  EXPECT_THAT(answers[2].error, HasSubstr("one line is an answer, but it also wrote"));
}

TEST_F(Numbered, FindsALineTooManyAmongManyQuestions) {
  start(std::string(kRepeating) + "; [ $i = 7 ] && " + kRepeating);
  EXPECT_EQ(ask().error, "");
  const std::vector<std::string> questions(20, R"({"x": 1})");
  const std::vector<JsonAnswer> answers = process_->ask_texts(questions, 1, milliseconds(5000));
  ASSERT_EQ(answers.size(), 8U);
  EXPECT_THAT(answers[7].error, HasSubstr("it answers n 7, expected 8"));
}

TEST_F(Numbered, RefusesAnAnswerWithoutTheNumberOnceItWasRepeated) {
  start(std::string("if [ $i = 1 ]; then ") + kPlain + "; else " + kRepeating + "; fi");
  EXPECT_EQ(ask().json["v"], 0);
  EXPECT_THAT(ask().error, HasSubstr("there is no 'n', which it had repeated before"));
}

TEST_F(Numbered, RefusesANumberThatIsNone) {
  start(R"(echo "{\"n\": \"0\"}")");
  EXPECT_THAT(ask().error, HasSubstr("it answers n \"0\", expected 0"));
}

TEST_F(Numbered, RefusesWhatIsNoObject) {
  start("echo 42");
  EXPECT_EQ(ask().error, "line 1 of its output, '42': expected a JSON object");
}

TEST_F(Numbered, SaysThatThereWasNoAnswerAtAll) {
  start("exit 3");
  EXPECT_TRUE(ask().silent);
}

}  // namespace
}  // namespace jaywalk
