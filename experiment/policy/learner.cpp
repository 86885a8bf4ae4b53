#include "experiment/policy/learner.h"

#include <algorithm>
#include <array>

namespace jaywalk {
namespace {

constexpr std::array kLearners = {
#define JAYWALK_LEARNER(function, name, summary) LearnerKind{name, summary, learners::function},
#include "experiment/policy/learners.def"
#undef JAYWALK_LEARNER
};

}  // namespace

std::span<const LearnerKind> learner_kinds() { return kLearners; }

const LearnerKind* find_learner(std::string_view name) {
  const auto found = std::ranges::find(kLearners, name, &LearnerKind::name);
  return found == kLearners.end() ? nullptr : &*found;
}

}  // namespace jaywalk
