// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/report.h"

#include <algorithm>
#include <array>
#include <utility>

#include "experiment/report/html.h"
#include "experiment/scenario/files/portable_names.h"

namespace jaywalk::reporting {
namespace {

constexpr std::array kSections = {
#define JAYWALK_SECTION(name, title) Section{#name, title, section::name},
#include "experiment/report/sections.def"
#undef JAYWALK_SECTION
};

std::string_view file_name(std::string_view path) { return path.substr(path.rfind('/') + 1); }

class DataReader {
 public:
  explicit DataReader(const ResultsReader& store)
      : store_(store), plan_(plan_of(store.description())) {}

  Result<ReportData> read() {
    data_.store = &store_;
    data_.store_path = portable_path(store_.path());
    data_.description = store_.description();
    take(store_.comparison(), data_.comparison);
    take(store_.prepared(), data_.prepared);
    read_facts();
    read_violations();
    choose_replays();
    if (trouble_.has_errors()) return std::move(trouble_);
    return std::move(data_);
  }

 private:
  template <class T>
  bool take(Result<T> result, T& target) {
    if (result) {
      target = std::move(result).value();
      return true;
    }
    trouble_.append(std::move(result.diagnostics()));
    return false;
  }
  void note(std::optional<Diagnostics> failure) {
    if (failure) trouble_.append(std::move(*failure));
  }

  /// The test with its number counted from the plan's first.
  [[nodiscard]] TestKey in_plan(TestKey test) const {
    test.number -= store_.description().first_test;
    return test;
  }
  [[nodiscard]] std::size_t behaviour_index(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::find(plan_.behaviours, name) -
                                    plan_.behaviours.begin());
  }

  void read_facts() {
    FactsTable table(plan_);
    for (const Summary& summary : data_.comparison.summaries) {
      const TestFilter cell{.behaviour = behaviour_index(summary.behaviour),
                            .agents = summary.agents};
      note(store_.for_each_test(cell, [&](const StoredTest& test) {
        table.add(in_plan(test.test), test.result);
        return Proceed::yes;
      }));
    }
    note(store_.for_each_place("precondition", [&](const TestKey& test, double x_m, double y_m) {
      if (test.vehicle == 0) table.add_place(in_plan(test), x_m, y_m);
    }));
    for (const Summary& summary : data_.comparison.summaries) {
      data_.facts.push_back(table.facts(behaviour_index(summary.behaviour), summary.agents));
    }
  }

  void read_violations() {
    if (data_.comparison.assertions.empty() || !data_.prepared) return;
    note(store_.for_each_assessed([&](const TestKey& test, const std::vector<AssessmentRow>& rows) {
      if (test.vehicle > 0) return;
      for (const AssessmentRow& row : rows) note_violation(test, row);
    }));
    // Assertions of files come first: they replace those of the scenario with the same ids.
    take(store_.assertions(), data_.assertions);
    for (const Assertion& assertion : data_.prepared->scenario().assertions) {
      if (std::ranges::find(data_.assertions, assertion.id, &Assertion::id) ==
          data_.assertions.end()) {
        data_.assertions.push_back(assertion);
      }
    }
    name_witnesses();
  }

  /// Keeps each behaviour's worst one of each assertion, the first of equals.
  void note_violation(const TestKey& test, const AssessmentRow& row) {
    if (row.verdict != StoredVerdict::fail) return;
    const double robustness = row.robustness.value_or(0);
    auto& all = candidates_[row.id];
    const auto found = all.find(test.behaviour);
    if (found != all.end() && found->second.violation.robustness <= robustness) return;
    all[test.behaviour] = {.violation = {.assertion = row.id,
                                         .test = test,
                                         .robustness = robustness,
                                         .tick = row.tick},
                           .actor = row.actor};
  }

  void name_witnesses() {
    for (const std::string& id : data_.comparison.assertions) {
      for (auto& [behaviour, each] : candidates_[id]) {
        std::vector<Actor> actors;
        take(store_.actors(test_id(store_.description(), each.violation.test)), actors);
        if (each.actor && *each.actor < actors.size()) {
          each.violation.witness = actors[*each.actor].name;
        }
        data_.violations.push_back(std::move(each.violation));
      }
    }
  }

  void add_replay(const StoredTest& stored, std::string reason) {
    if (find_replay(data_, stored.test) != nullptr) return;
    ReplayLink link{.test = stored.test, .reason = std::move(reason)};
    if (stored.scenes > 0) take(store_.recording(stored.id), link.recording);
    data_.replays.push_back(std::move(link));
  }

  /// A test of each behaviour, and the worst of each assertion.
  void choose_replays() {
    const std::vector<std::uint32_t> agents = agents_of(data_.comparison);
    if (agents.empty()) return;
    const std::uint32_t middle = agents[(agents.size() - 1) / 2];
    for (const std::string& behaviour : behaviours_of(data_.comparison)) {
      std::vector<StoredTest> tests;
      take(store_.tests({.behaviour = behaviour_index(behaviour),
                         .agents = middle,
                         .succeeded = true,
                         .limit = 1}),
           tests);
      if (!tests.empty()) add_replay(tests.front(), "the first that met the precondition");
    }
    for (const std::string& assertion : data_.comparison.assertions) {
      const Violation* worst = nullptr;
      for (const Violation& each : data_.violations) {
        if (each.assertion != assertion) continue;
        if (worst == nullptr || each.robustness < worst->robustness) worst = &each;
      }
      if (worst == nullptr) continue;
      auto stored = store_.test(test_id(store_.description(), worst->test));
      if (stored) add_replay(stored.value(), "violates " + assertion + " most");
    }
  }

  struct Candidate {
    Violation violation;
    std::optional<std::uint32_t> actor;
  };

  const ResultsReader& store_;
  ExperimentPlan plan_;
  ReportData data_;
  /// By assertion and behaviour.
  std::map<std::string, std::map<std::size_t, Candidate>> candidates_;
  Diagnostics trouble_;
};

}  // namespace

std::span<const Section> sections() { return kSections; }

std::vector<std::string> behaviours_of(const Comparison& comparison) {
  std::vector<std::string> names;
  for (const Summary& summary : comparison.summaries) {
    if (std::ranges::find(names, summary.behaviour) == names.end()) {
      names.push_back(summary.behaviour);
    }
  }
  return names;
}

std::vector<std::uint32_t> agents_of(const Comparison& comparison) {
  std::vector<std::uint32_t> numbers;
  for (const Summary& summary : comparison.summaries) numbers.push_back(summary.agents);
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

const Summary* find_summary(const Comparison& comparison, std::string_view behaviour,
                            std::uint32_t agents) {
  const auto found = std::ranges::find_if(comparison.summaries, [&](const Summary& summary) {
    return summary.behaviour == behaviour && summary.agents == agents;
  });
  return found == comparison.summaries.end() ? nullptr : &*found;
}

const ReplayLink* find_replay(const ReportData& data, const TestKey& test) {
  const auto found = std::ranges::find_if(data.replays, [&](const ReplayLink& link) {
    return link.test.behaviour == test.behaviour && link.test.agents == test.agents &&
           link.test.number == test.number;
  });
  return found == data.replays.end() ? nullptr : &*found;
}

std::string render_report(const ReportData& data) {
  std::vector<PageSection> written;
  for (const Section& section : sections()) {
    written.push_back({section.name, section.title, section.render(data)});
  }
  return render_page("Jaywalk test report", file_name(data.comparison.scenario), written);
}

Result<ReportData> read_report_data(const ResultsReader& store) { return DataReader(store).read(); }

}  // namespace jaywalk::reporting
