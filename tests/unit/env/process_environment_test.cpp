// SPDX-License-Identifier: Apache-2.0
// A world that is a program: what it is asked, what agents perceive and how their actions end by
// its answers, and what is said of answers that are wrong.

#include "env/environment_process/process_environment.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/environment/percepts.h"
#include "tests/helpers/folder.h"

namespace jaywalk {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Two agents, ann and bob, in the world of a shell that answers with given lines and keeps what it
/// is asked.
class AWorld : public FolderTest {
 protected:
  /// `answers`: the fields of the answers to `hello`, `init` and so on, without the number.
  void make(const std::vector<std::string>& answers, double answer_s = 20) {
    std::string script;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      std::string line =
          "{\"n\": " + std::to_string(i) + (answers[i].empty() ? "" : ", " + answers[i]) + "}";
      std::ranges::replace(line, '\n', ' ');
      script += "read -r q; " + kKeep + "printf '%s\\n' '" + line + "'; ";
    }
    make_script(script + "read -r q; " + kKeep, answer_s);
  }
  void make_script(const std::string& script, double answer_s = 20) {
    world_ = std::make_unique<ProcessEnvironment>(ProcessEnvironment::Settings{
        .command = {"sh", "-c", script},
        .folder = path(),
        .arguments = {"kitchen", "\"a b\"", "3"},
        .answer_s = answer_s,
        .show = [this](std::string_view text) { shown_ += text; },
        .show_errors = [this](std::string_view text) { errors_ += text; }});
  }
  /// With a world that says hello, and answers `init` so.
  void begin(const std::string& init, std::vector<std::string> ticks = {}) {
    ticks.insert(ticks.begin(), {kHello, init});
    make(ticks);
    ASSERT_TRUE(world_->start()) << world_->failure();
    (void)begin_run();
  }
  bool begin_run() {
    world_->use_names(symbols_);
    return world_->begin_run(
        42, {.count = 2,
             .name = [](AgentId id) { return kNames[static_cast<std::size_t>(id)]; },
             .next_timer_ms = [this] { return next_timer_ms_; }});
  }

  /// Lets an agent look, and returns what it perceives.
  std::vector<std::string> look(std::uint32_t agent) {
    Percepts percepts;
    percepts.begin_look();
    world_->perceive(AgentId{agent}, percepts);
    percepts.end_look();
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < percepts.size(); ++i) {
      texts.push_back(literal_text(percepts.predicate(i), percepts.args(i), symbols_));
    }
    return texts;
  }
  /// A tick in which ann and bob, or only these agents, look and then do this.
  std::vector<ActionResult> tick(const std::vector<ActionRequest>& actions = {},
                                 const std::vector<std::uint32_t>& agents = {0, 1}) {
    late_.clear();
    world_->take_results([this](std::uint64_t number, const ActionResult& result) {
      late_.push_back(std::to_string(number) + (result.succeeded ? "" : " " + result.reason));
    });
    for (const std::uint32_t agent : agents) {
      if (!world_->is_unchanged(AgentId{agent})) (void)look(agent);
    }
    std::vector<ActionResult> results(actions.size());
    world_->execute(actions, results);
    world_->advance();
    return results;
  }
  ActionRequest action(std::uint32_t agent, const char* functor, std::vector<Value> args = {}) {
    arguments_.push_back(std::move(args));
    return {.agent = AgentId{agent},
            .predicate = predicate_named(symbols_, functor, arguments_.back().size()),
            .args = arguments_.back(),
            .number = ++actions_};
  }
  Value atom(const char* name) { return Value::atom(predicate_named(symbols_, name, 0)); }
  /// All questions, once the world has ended.
  std::vector<json> asked() {
    world_.reset();
    std::istringstream lines(text("asked"));
    std::vector<json> questions;
    for (std::string line; std::getline(lines, line);) questions.push_back(json::parse(line));
    return questions;
  }

  static constexpr const char* kHello = R"j("protocol": 1, "name": "shell", "version": "2")j";
  inline static const std::string kKeep = "printf '%s\\n' \"$q\" >>asked; ";
  inline static const std::vector<std::string> kNames{"ann", "bob", "cleo"};
  SymbolTable symbols_;
  std::deque<std::vector<Value>> arguments_;
  std::uint64_t actions_ = 0;
  std::optional<double> next_timer_ms_;
  std::vector<std::string> late_;
  std::string shown_;
  std::string errors_;
  std::unique_ptr<ProcessEnvironment> world_;
};

TEST_F(AWorld, SaysWhoItIs) {
  make({R"j("protocol": 1, "name": "room", "version": "3", "tick_ms": 50, "deterministic": true,
           "percepts": [{"form": "door(State)", "meaning": "open or shut"}], "actions": [], "colour": 1)j"});
  ASSERT_TRUE(world_->start()) << world_->failure();
  EXPECT_EQ(world_->identity().name, "room");
  EXPECT_EQ(world_->identity().version, "3");
  EXPECT_EQ(world_->tick_ms(), 50);
  EXPECT_TRUE(world_->identity().deterministic);
  EXPECT_FALSE(world_->identity().free_running);
  ASSERT_TRUE(world_->identity().percepts);
  EXPECT_EQ(world_->identity().percepts->at(0).form, "door(State)");
  EXPECT_THAT(*world_->identity().actions, IsEmpty());
}

TEST_F(AWorld, IsToldOfTheRun) {
  begin("");
  const std::vector<json> questions = asked();
  ASSERT_EQ(questions.size(), 3U);
  EXPECT_EQ(questions[0]["type"], "hello");
  EXPECT_EQ(questions[0]["protocol"], 1);
  EXPECT_EQ(questions[0]["arguments"], json({"kitchen", "\"a b\"", "3"}));
  EXPECT_EQ(questions[1]["type"], "init");
  EXPECT_EQ(questions[1]["n"], 1);
  EXPECT_EQ(questions[1]["seed"], 42);
  EXPECT_EQ(questions[1]["agents"], json({"ann", "bob"}));
  EXPECT_EQ(questions[2], json({{"type", "bye"}, {"n", 2}}));
}

TEST_F(AWorld, GivesEachAgentItsPercepts) {
  begin(
      R"j("percepts": {"ann": ["at(2, -1.5)", "~raining", "at(2,-1.5)"], "*": ["warm", "time(0)"]})j");
  EXPECT_EQ(world_->failure(), "");
  EXPECT_THAT(look(0), ElementsAre("warm", "time(0)", "at(2,-1.5)", "~raining"));
  EXPECT_THAT(look(1), ElementsAre("warm", "time(0)"));
}

TEST_F(AWorld, KeepsWhatItDoesNotName) {
  begin(R"j("percepts": {"ann": ["at(1)"], "bob": ["at(2)"], "*": ["warm"]})j",
        {R"j("percepts": {"ann": ["at(3)"]})j", "", R"j("percepts": {"*": []})j"});
  tick();
  EXPECT_THAT(look(0), ElementsAre("warm", "at(3)"));
  EXPECT_THAT(look(1), ElementsAre("warm", "at(2)"));
  tick();
  EXPECT_THAT(look(0), ElementsAre("warm", "at(3)"));
  tick();
  EXPECT_THAT(look(1), ElementsAre("at(2)"));
  EXPECT_EQ(world_->failure(), "");
}

TEST_F(AWorld, ChangesPercepts) {
  begin(
      R"j("percepts": {"ann": ["a", "b", "c"], "*": ["w"]})j",
      {R"j("changes": {"ann": {"remove": ["b", "z"], "add": ["d", "c"]}, "*": {"add": ["v"]}})j"});
  tick();
  EXPECT_EQ(world_->failure(), "");
  EXPECT_THAT(look(0), ElementsAre("w", "v", "a", "c", "d"));
}

TEST_F(AWorld, PerceivesOnceWhatAllPerceive) {
  begin(R"j("percepts": {"ann": ["warm", "a"], "*": ["warm"]})j");
  EXPECT_THAT(look(0), ElementsAre("warm", "a"));
}

TEST_F(AWorld, IsAskedForActions) {
  begin("", {R"j("done": [{"id": 2, "failed": "the door is locked"}, {"id": 1}])j", ""});
  const std::vector<ActionResult> results = tick(
      {action(0, "open", {atom("door"), Value::number(2), Value::number(0.5)}), action(1, "wave")});
  ASSERT_EQ(results.size(), 2U);
  EXPECT_TRUE(results[0].succeeded);
  EXPECT_FALSE(results[1].succeeded);
  EXPECT_EQ(results[1].reason, "the door is locked");
  tick();
  const std::vector<json> questions = asked();
  EXPECT_EQ(questions[2], json::parse(R"j({"n": 2, "type": "tick", "time_ms": 0.0, "actions": [
      {"id": 1, "agent": "ann", "action": "open(door,2,0.5)", "name": "open", "args": ["door", 2, 0.5]
},
      {"id": 2, "agent": "bob", "action": "wave", "name": "wave", "args": []}]
})j"));
  EXPECT_EQ(questions[3]["time_ms"], 1000);
  EXPECT_EQ(questions[3]["actions"], json::array());
}

TEST_F(AWorld, LetsActionsTakeLonger) {
  begin("", {R"j("done": [{"id": 2}])j", "",
             R"j("done": [{"id": 3}, {"id": 1, "failed": "it fell"}])j", ""});
  const std::vector<ActionResult> first = tick({action(0, "carry"), action(1, "wave")});
  EXPECT_TRUE(first[0].is_pending);
  EXPECT_FALSE(first[1].is_pending);
  EXPECT_TRUE(tick({action(1, "look")})[0].is_pending);
  EXPECT_THAT(late_, IsEmpty());
  tick();
  EXPECT_THAT(late_, IsEmpty());
  tick();
  EXPECT_THAT(late_, ElementsAre("1 it fell", "3"));
  EXPECT_EQ(world_->failure(), "");
}

TEST_F(AWorld, SaysWhatHasNotChanged) {
  begin(R"j("percepts": {"ann": ["a"], "*": ["w"]})j",
        {"", R"j("changes": {"ann": {"add": ["b"]}})j", R"j("percepts": {"*": ["v"]})j", ""});
  const auto unchanged = [this](std::uint32_t agent) {
    return world_->is_unchanged(AgentId{agent});
  };
  EXPECT_FALSE(unchanged(0));
  EXPECT_FALSE(unchanged(1));
  tick();
  EXPECT_TRUE(unchanged(0));
  EXPECT_TRUE(unchanged(1));
  tick();
  EXPECT_FALSE(unchanged(0));
  EXPECT_TRUE(unchanged(1));
  tick();
  EXPECT_FALSE(unchanged(0));
  EXPECT_FALSE(unchanged(1));
  tick();
  EXPECT_TRUE(unchanged(0));
}

TEST_F(AWorld, IsToldThatAllAreIdle) {
  begin("", {"", R"j("done": [{"id": 1}])j", "", ""});
  tick({action(0, "wave")});
  tick();
  next_timer_ms_ = 5000;
  tick();
  next_timer_ms_.reset();
  tick();
  const std::vector<json> questions = asked();
  EXPECT_FALSE(questions[2].contains("idle")) << "an action is under way";
  EXPECT_FALSE(questions[3].contains("idle"));
  EXPECT_FALSE(questions[4].contains("idle")) << "a timer is pending";
  EXPECT_EQ(questions[5]["idle"], true);
}

TEST_F(AWorld, GivesPerceptsOfAnyTerms) {
  begin(
      R"j("percepts": {"ann": ["says(\"a b\",[1,x(2)])[from(north)]", "says(\"a b\", [1, x(2)])"]})j");
  EXPECT_EQ(world_->failure(), "");
  EXPECT_THAT(look(0), ElementsAre("says(\"a b\",[1,x(2)])"));
}

TEST_F(AWorld, HearsThatAgentsLeaveAndJoin) {
  begin(R"j("percepts": {"bob": ["a"]})j",
        {"", R"j("percepts": {"cleo": ["b"]})j", R"j("percepts": {"bob": ["late"]})j"});
  tick({}, {0, 1});
  tick({}, {0, 2});  // question 3, then 4
  EXPECT_EQ(world_->failure(), "");
  EXPECT_THAT(look(2), ElementsAre("b"));
  EXPECT_THAT(look(1), IsEmpty()) << "it has left";
  const std::vector<json> questions = asked();
  EXPECT_EQ(questions[3]["type"], "agents");
  EXPECT_EQ(questions[3]["agents"], json({"ann", "cleo"}));
  EXPECT_EQ(questions[3]["left"], json({"bob"}));
  EXPECT_EQ(questions[3]["joined"], json({"cleo"}));
  EXPECT_EQ(questions[4]["type"], "tick");
}

TEST_F(AWorld, HearsOfAnAgentThatActsBeforeItLooks) {
  begin("", {"", R"j("done": [{"id": 1}], "percepts": {"cleo": ["b"]})j"});
  EXPECT_TRUE(tick({action(2, "wave")})[0].succeeded);
  EXPECT_EQ(world_->failure(), "");
  EXPECT_THAT(look(2), ElementsAre("b"));
  EXPECT_EQ(asked()[2]["joined"], json({"cleo"}));
}

TEST_F(AWorld, ShowsItsTextAndItsErrors) {
  make_script("read q; echo oops >&2; echo '{\"n\": 0, " + std::string(kHello) +
              "}'; read q; printf '%s\\n' '{\"n\": 1, \"text\": \"\\u001b[2Jhouse\\n\"}'; read q");
  ASSERT_TRUE(world_->start());
  ASSERT_TRUE(begin_run());
  EXPECT_EQ(errors_, "oops");
  EXPECT_EQ(shown_, "\x1b[2Jhouse\n");
}

TEST_F(AWorld, EndsTheRun) {
  begin("", {R"j("finished": false)j", R"j("finished": true)j"});
  EXPECT_FALSE(world_->finished());
  tick();
  EXPECT_FALSE(world_->finished());
  tick();
  EXPECT_TRUE(world_->finished());
  EXPECT_EQ(world_->failure(), "");
}

TEST_F(AWorld, LivesByTheWallClockIfItWants) {
  make({std::string(kHello) + R"j(, "free_running": true)j", "", "", ""});
  ASSERT_TRUE(world_->start());
  ASSERT_TRUE(begin_run());
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  tick();
  EXPECT_GE(world_->tick_ms(), 30);
  EXPECT_LT(world_->tick_ms(), 20'000);
  next_timer_ms_ = world_->tick_ms() + 200;
  tick();
  const std::vector<json> questions = asked();
  EXPECT_EQ(questions[2]["wait_ms"], 1000);
  EXPECT_NEAR(questions[3]["wait_ms"].get<double>(), 200, 1);
}

// A wrong answer ends the world, and the message has its line number.

TEST_F(AWorld, RefusesAWrongHello) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {R"j("name": "x", "version": "1")j", "there is no 'protocol' in its hello"},
      {R"j("protocol": 7, "name": "x", "version": "1")j",
       "it speaks version 7 of the protocol, this is version 1"},
      {R"j("protocol": 1, "name": 3, "version": "1")j", "'name' in its hello is not a text"},
      {R"j("protocol": 1, "name": "x", "version": "1", "tick_ms": 0)j",
       "its 'tick_ms' is 0, expected more than 0"},
      {R"j("protocol": 1, "name": "x", "version": "1", "tick_ms": "1")j",
       "'tick_ms' in its hello is not a number"},
      {R"j("protocol": 1, "name": "x", "version": "1", "actions": [{"form": "go("}])j",
       "'go(' in the 'actions' of its hello is no form such as at(X,Y)"},
      {R"j("protocol": 1, "name": "x", "version": "1", "percepts": {"at(X)": ""})j",
       "'percepts' in its hello is not a list"},
      {R"j("error": "no robot is connected")j", "it reports 'no robot is connected'"}};
  for (const auto& [answer, message] : wrong) {
    make({answer});
    EXPECT_FALSE(world_->start());
    EXPECT_THAT(world_->failure(), HasSubstr(message)) << answer;
  }
}

TEST_F(AWorld, RefusesWrongAnswers) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {R"j("percepts": ["a"])j", "'percepts' is not an object"},
      {R"j("percepts": {"ann": "a"})j", "the percepts of 'ann' are not a list"},
      {R"j("percepts": {"ann": [1]})j", "a percept of ann is not a text: 1"},
      {R"j("percepts": {"anm": []})j", "there is no agent 'anm'; did you mean 'ann'?"},
      {R"j("changes": {"ann": ["a"]})j", "the changes of 'ann' are not an object"},
      {R"j("changes": {"ann": {"add": "a"}})j", "the percepts of 'ann' are not a list"},
      {R"j("done": {"id": 0})j", "'done' is not a list"},
      {R"j("done": [0])j", R"j('done' has 0, expected {"id": <number of an action>})j"},
      {R"j("done": [{"id": -1}])j", R"j('done' has {"id":-1})j"},
      {R"j("done": [{"id": 7}])j", "no action 7 is under way"},
      {R"j("done": [{"id": 1}, {"id": 1}])j", "no action 1 is under way"},
      {R"j("done": [{"id": 1, "failed": true}])j", "the reason why action 1 failed is not a text"},
      {R"j("finished": 1)j", "'finished' in its answer is not true or false"},
      {R"j("text": ["a"])j", "'text' in its answer is not a text"},
      {R"j("error": "out of beer")j", "it reports 'out of beer'"}};
  for (const auto& [answer, message] : wrong) {
    actions_ = 0;
    begin("", {answer});
    EXPECT_FALSE(world_->finished());
    tick({action(0, "wave")});
    EXPECT_THAT(world_->failure(), HasSubstr(message)) << answer;
    if (!answer.starts_with("\"error")) {
      EXPECT_THAT(world_->failure(), HasSubstr("line 3 of its output, '{\"n\": 2")) << answer;
    }
    EXPECT_TRUE(world_->finished()) << answer;
  }
}

TEST_F(AWorld, RefusesAnswersToOtherQuestions) {
  for (const char* number : {"{\"n\": 5}", "{}"}) {
    make_script("read q; echo '{\"n\": 0, " + std::string(kHello) + "}'; read q; echo '" + number +
                "'; read q");
    ASSERT_TRUE(world_->start());
    EXPECT_FALSE(begin_run());
    EXPECT_THAT(world_->failure(), HasSubstr("line 2 of its output, '" + std::string(number)));
  }
  make_script("read q; echo '" + std::string("{") + kHello + "}'; read q");
  EXPECT_FALSE(world_->start());
  EXPECT_THAT(world_->failure(), HasSubstr("there is no 'n', the number of the question"));
}

TEST_F(AWorld, PointsAtEveryMistakeInItsPercepts) {
  begin(R"j("percepts": {"ann": ["at(1, X)", "good(1)", "bad(", ".print(1)", "3"]})j");
  EXPECT_THAT(world_->failure(), HasSubstr("line 2 of its output"));
  ASSERT_EQ(world_->mistakes().error_count(), 4U) << world_->mistakes().render();
  const std::string first = render(world_->mistakes().items()[0]);
  EXPECT_THAT(first, HasSubstr("a percept of ann:1:7: error: "));
  EXPECT_THAT(first, HasSubstr("at(1, X)\n        ^"));
}

TEST_F(AWorld, DoesNotWaitForEver) {
  make_script("read q; echo '{\"n\": 0, " + std::string(kHello) + "}'; read q; sleep 60", 0.05);
  ASSERT_TRUE(world_->start());
  EXPECT_FALSE(begin_run());
  EXPECT_EQ(world_->failure(), "no answer within 0.05 s");
}

TEST_F(AWorld, SaysHowItsProgramEnded) {
  make_script("read q; echo 'no map' >&2; exit 3");
  EXPECT_FALSE(world_->start());
  EXPECT_EQ(world_->failure(),
            "it ended with exit code 3 before it answered; its last words were 'no map'");
  EXPECT_EQ(errors_, "no map");
}

// Far more texts than are kept: those that are perceived stay what they are.
TEST_F(AWorld, ForgetsTextsThatNoAgentPerceives) {
  SymbolTable symbols;
  PerceptTexts texts(symbols);
  Diagnostics problems;
  const PerceptPtr kept = texts.read("at(1,2)", "it", problems);
  const PerceptPtr same = texts.read("at( 1, 2 )[x]", "it", problems);
  EXPECT_EQ(same->content, kept->content);
  for (int i = 0; i < 50'000; ++i) {
    const PerceptPtr passing = texts.read("time(" + std::to_string(i) + ")", "it", problems);
    ASSERT_EQ(passing->literal.args()[0].as_number(), i);
  }
  EXPECT_EQ(texts.read("at(1,2)", "it", problems), kept);
  EXPECT_EQ(texts.read("at( 1, 2 )", "it", problems)->content, kept->content);
  EXPECT_LT(texts.size(), 25'000U);
  EXPECT_TRUE(problems.empty());
}

}  // namespace
}  // namespace jaywalk
