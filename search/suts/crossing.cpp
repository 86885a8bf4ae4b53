// The pedestrians' world as a SUT: a scenario with a behaviour, some of whose values a search
// chooses; measured are the metrics of the recorded test and, if asked for, assertions. So search,
// random behaviour and BDI agents are compared on one footing.

#include <algorithm>
#include <array>
#include <bit>

#include <fmt/format.h>

#include "env/ground.h"
#include "experiment/assertions/assertion.h"
#include "experiment/carry_over.h"
#include "experiment/metrics/metrics.h"
#include "experiment/metrics/naturalness.h"
#include "experiment/scenario_schema.h"
#include "experiment/trial.h"
#include "search/suts/crossing_space.h"
#include "search/suts/suts.h"

namespace jaywalk::search {
namespace {

/// What stands for a metric or a robustness that does not exist or is infinite.
constexpr double kNone = 1e6;
/// A pedestrian's last so many seconds tell how a test went.
constexpr std::size_t kSignatureTicks = 8;
constexpr std::uint32_t kMostAgents = 100;

struct CrossingSettings {
  SourcePtr scenario;
  std::string behaviour;
  std::uint32_t agents = 1;
  std::uint64_t seed = 0;
  std::vector<Assertion> assertions;
  /// Where programs are looked for.
  SourceFiles files;
  IncludeFolders include;
};

double bounded(double value) { return std::clamp(value, -kNone, kNone); }

/// The share of the pedestrians' steps that a person might take: not straight back, and not
/// standing still in the road.
double naturalness(const TestView& view) {
  double steps = 0;
  double natural = 0;
  for (const ActorIndex actor : view.road_users()) {
    for (std::size_t tick = 1; tick < view.ticks(); ++tick) {
      steps += 1;
      if (is_natural_step(view, actor, tick)) natural += 1;
    }
  }
  return steps > 0 ? natural / steps : 1;
}

/// The last seconds of the pedestrian who is nearest to the AV at the end, seen from the AV.
std::vector<double> last_approach(const TestView& view) {
  std::vector<double> numbers(2 * kSignatureTicks);
  if (view.road_users().empty()) return numbers;
  const ActorIndex actor = view.nearest().back();
  for (std::size_t i = 0; i < kSignatureTicks; ++i) {
    const std::size_t tick = view.ticks() - 1 - std::min(i, view.ticks() - 1);
    const ActorState& av = view.state(kAv, tick);
    const ActorState& other = view.state(actor, tick);
    numbers[2 * i] = other.x_m - av.x_m;
    numbers[2 * i + 1] = other.y_m - av.y_m;
  }
  return numbers;
}

Outcome failed(const Diagnostics& diagnostics) {
  return {.error =
              diagnostics.empty() ? "the test cannot be run" : diagnostics.items().front().message};
}

class CrossingRun : public Sut {
 public:
  CrossingRun(const CrossingSpace& space, const CrossingSettings& settings)
      : space_(space), settings_(settings) {}

  Outcome run(const TestInput& input, std::size_t) override {
    ScenarioOptions options{.sets = space_.settings(input),
                            .behaviours = {settings_.behaviour},
                            .files = settings_.files,
                            .include = settings_.include};
    Result<Scenario> scenario = parse_scenario(settings_.scenario, options);
    if (!scenario.ok()) return failed(scenario.diagnostics());
    if (std::vector<Position> starts = space_.starts(input); !starts.empty()) {
      scenario.value().start_cells = StartCells{{0, std::move(starts)}};
    }
    if (test_order(scenario.value()) == TestOrder::chained) {
      return {.error = "world.av.carry_over: a test that is searched has none before it"};
    }
    Diagnostics warnings;
    const auto prepared = PreparedScenario::prepare(std::move(scenario).value(), warnings);
    if (!prepared.ok()) return failed(prepared.diagnostics());
    Recording recording;
    const TrialInput trial{.agents = settings_.agents, .seed = seed(input), .test = 0};
    const TrialResult result = run_trial(*prepared.value(), trial, {.record = &recording});
    if (!result.completed) return {.error = result.message};
    const Ground where = ground(prepared.value()->scenario().world);
    return measured(result, TestView(recording, where));
  }

 private:
  /// Chance is a function of the input, so that the same input always has the same outcome.
  [[nodiscard]] std::uint64_t seed(const TestInput& input) const {
    std::uint64_t seed = settings_.seed;
    for (const double value : input.values) seed = mix(seed, std::bit_cast<std::uint64_t>(value));
    return seed;
  }

  [[nodiscard]] Outcome measured(const TrialResult& result, const TestView& view) const {
    Outcome outcome;
    outcome.simulated_s = static_cast<double>(view.ticks() - 1) * view.tick_s();
    const auto nearest = jaywalk::measured(*find_metric("min_distance"), view);
    const double distance = nearest ? nearest->value : kNone;
    outcome.measures = {result.outcome.success ? 1 : 0.9 / (1 + distance / 5),
                        result.outcome.success ? 1.0 : 0.0, naturalness(view)};
    for (const Metric& metric : metrics()) {
      const auto value = jaywalk::measured(metric, view);
      const double missing = metric.worst == Worst::least ? kNone : 0;
      outcome.measures.push_back(value ? bounded(value->value) : missing);
    }
    for (const Assertion& assertion : settings_.assertions) {
      const Judgement judgement = judge(assertion, view);
      outcome.measures.push_back(bounded(judgement.exercised));
      outcome.measures.push_back(judgement.robustness ? bounded(*judgement.robustness) : kNone);
    }
    outcome.signature = last_approach(view);
    return outcome;
  }

  const CrossingSpace& space_;
  const CrossingSettings& settings_;
};

class CrossingModel : public SutModel {
 public:
  CrossingModel(CrossingSettings settings, std::vector<CrossingDimension> dimensions,
                std::vector<int> rows, int cells, bool searches_starts)
      : settings_(std::move(settings)),
        space_(std::move(dimensions), std::move(rows), cells,
               searches_starts ? settings_.agents : 0) {
    for (const Assertion& assertion : settings_.assertions) {
      names_.push_back(fmt::format("{}_exercised", assertion.id));
      names_.push_back(fmt::format("{}_robustness", assertion.id));
    }
    kinds_ = {{"exercised", "1 if the precondition was met, else less the farther all stayed away"},
              {"precondition", "1 if the precondition of the AV's assertion was met, else 0"},
              {"naturalness", "share of steps that a person might take, 0 to 1"}};
    for (const Metric& metric : metrics()) kinds_.push_back({metric.name, metric.formula});
    for (const std::string& name : names_) kinds_.push_back({name, "of the assertion"});
  }

  [[nodiscard]] const SearchSpace& space() const override { return space_; }
  [[nodiscard]] std::span<const MeasureKind> measures() const override { return kinds_; }
  [[nodiscard]] std::unique_ptr<Sut> make() const override {
    return std::make_unique<CrossingRun>(space_, settings_);
  }
  [[nodiscard]] std::vector<SutSetting> settings() const override {
    return {{"scenario", settings_.scenario->name()},
            {"behaviour", settings_.behaviour},
            {"pedestrians", std::to_string(settings_.agents)},
            {"dimensions of the search", std::to_string(space_.dimension())}};
  }

 private:
  CrossingSettings settings_;
  CrossingSpace space_;
  std::vector<std::string> names_;
  std::vector<MeasureKind> kinds_;
};

/// Reads the keys of the SUT and tries one test, so that mistakes are found at once.
class CrossingReader {
 public:
  explicit CrossingReader(const SutSetup& setup) : setup_(setup), reader_(setup.reader) {}

  std::shared_ptr<const SutModel> read() {
    const auto ignored = [](const ConfigNode&, const std::string&) {};
    const std::vector<ConfigKey> keys{
        {"kind", ignored},
        {"scenario", [&](const ConfigNode& value, const std::string&) { read_scenario(value); }},
        {"behaviour",
         [&](const ConfigNode& value, const std::string&) {
           if (auto name = reader_.text(value, "a behaviour")) settings_.behaviour = *name;
         }},
        {"agents",
         [&](const ConfigNode& value, const std::string&) {
           if (const auto count = reader_.integer(value, {1, kMostAgents})) {
             settings_.agents = static_cast<std::uint32_t>(*count);
           }
         }},
        {"seed",
         [&](const ConfigNode& value, const std::string&) {
           if (const auto seed = reader_.integer(value, {0, INT64_MAX})) {
             settings_.seed = static_cast<std::uint64_t>(*seed);
           }
         }},
        {"starts",
         [&](const ConfigNode& value, const std::string&) {
           const std::array choices = {Choice<bool>{"searched", true},
                                       Choice<bool>{"chance", false}};
           if (const auto chosen = reader_.choice<bool>(value, choices)) searches_starts_ = *chosen;
         }},
        {"assertions",
         [&](const ConfigNode& value, const std::string&) { read_assertions(value); }},
        {"parameters",
         [&](const ConfigNode& value, const std::string&) { read_dimensions(value); }},
    };
    reader_.read_map(setup_.node, setup_.path, keys);
    if (!settings_.scenario) {
      if (setup_.node.find("scenario") == nullptr) {
        reader_.error(setup_.node.origin, "no 'scenario' whose tests are searched");
      }
      return nullptr;
    }
    return make();
  }

 private:
  void read_scenario(const ConfigNode& value) {
    const auto path = reader_.text(value, "the path of a scenario");
    if (!path) return;
    Result<SourcePtr> source = read_source(path_in(setup_.folder, *path), kMaxScenarioBytes);
    if (source.ok()) {
      settings_.scenario = source.value();
    } else {
      reader_.error(value.origin, fmt::format("cannot read '{}'", *path));
    }
  }

  void read_assertions(const ConfigNode& value) {
    const auto path = reader_.text(value, "the path of a file of assertions");
    if (!path) return;
    Result<std::vector<Assertion>> read = jaywalk::read_assertions(path_in(setup_.folder, *path));
    if (read.ok()) {
      settings_.assertions = std::move(read).value();
    } else {
      reader_.error(value.origin,
                    fmt::format("'{}': {}", *path, read.diagnostics().items().front().message));
    }
  }

  /// A map from the scenario's keys to [from, to], `{whole: [from, to]}` or a list of words.
  void read_dimensions(const ConfigNode& node) {
    if (node.kind != ConfigNode::Kind::map) {
      reader_.unexpected(node, "keys of the scenario and their ranges");
      return;
    }
    for (const ConfigEntry& entry : node.entries) {
      CrossingDimension dimension{.key = entry.key};
      if (read_range(entry.value, dimension)) {
        dimensions_.push_back(std::move(dimension));
      }
    }
  }

  bool read_range(const ConfigNode& node, CrossingDimension& dimension) {
    if (node.kind == ConfigNode::Kind::list && !node.items.empty() &&
        !parse_number(node.items.front().text)) {
      dimension.kind = CrossingDimension::Kind::word;
      for (const ConfigNode& item : node.items) {
        const auto word = reader_.text(item, "a word");
        if (!word) return false;
        dimension.words.push_back(*word);
      }
      return true;
    }
    const ConfigNode* range = &node;
    if (const ConfigNode* whole = node.find("whole")) {
      dimension.kind = CrossingDimension::Kind::whole;
      range = whole;
    }
    const auto numbers = reader_.number_pair(*range, {-1e6, 1e6});
    if (!numbers) return false;
    dimension.from = (*numbers)[0];
    dimension.to = (*numbers)[1];
    return true;
  }

  std::shared_ptr<const SutModel> make() {
    ScenarioOptions options{.files = setup_.files, .include = setup_.include};
    if (!settings_.behaviour.empty()) options.behaviours = {settings_.behaviour};
    settings_.files = setup_.files;
    settings_.include = setup_.include;
    Result<Scenario> scenario = parse_scenario(settings_.scenario, options);
    if (!scenario.ok()) {
      reader_.error_in(setup_.node.origin, scenario.diagnostics());
      return nullptr;
    }
    settings_.behaviour = scenario.value().behaviours.front().name;
    const CrossingParameters& world = scenario.value().world;
    auto model = std::make_shared<CrossingModel>(settings_, dimensions_, pavement_rows(world),
                                                 world.length, searches_starts_);
    if (tried(*model, std::move(scenario).value())) return model;
    return nullptr;
  }

  static std::vector<int> pavement_rows(const CrossingParameters& world) {
    std::vector<int> rows;
    int row = 0;
    for (const Band& band : world.bands) {
      for (int i = 0; i < band.rows; ++i, ++row) {
        if (band.kind == BandKind::pavement) rows.push_back(row);
      }
    }
    return rows;
  }

  /// Whether the least and the greatest values make tests that can be run. What is wrong with the
  /// scenario and its programs whatever the values is reported with its own places.
  bool tried(const CrossingModel& model, Scenario scenario) {
    for (const double value : {-1.0, 1.0}) {
      const TestInput input{Form::vector, std::vector<double>(model.space().dimension(), value)};
      const Outcome outcome = model.make()->run(input, 0);
      if (outcome.executed()) continue;
      Diagnostics warnings;
      auto prepared = PreparedScenario::prepare(std::move(scenario), warnings);
      if (!prepared.ok()) {
        reader_.error_in(setup_.node.origin, prepared.diagnostics());
        return false;
      }
      reader_.error(setup_.node.origin,
                    fmt::format("with the {} values of its parameters a test cannot be run: {}",
                                value < 0 ? "least" : "greatest", outcome.error));
      return false;
    }
    return true;
  }

  const SutSetup& setup_;
  const ConfigReader& reader_;
  CrossingSettings settings_;
  std::vector<CrossingDimension> dimensions_;
  bool searches_starts_ = true;
};

}  // namespace

namespace sut::crossing {

std::shared_ptr<const SutModel> read(const SutSetup& setup) { return CrossingReader(setup).read(); }

}  // namespace sut::crossing

}  // namespace jaywalk::search
