#include "search/generators/sequences.h"

#include <algorithm>

namespace jaywalk::search {

void append_random(std::vector<double>& values, int count, Random& random) {
  for (; count > 0; --count) {
    const double last = values.empty() ? 0 : values.back();
    values.push_back(random.uniform(std::max(-1.0, last - kMostDifference),
                                    std::min(1.0, last + kMostDifference)));
  }
}

TestInput draw_sequence(const SequenceBounds& bounds, Random& random) {
  const auto spread = static_cast<int>(bounds.spread);
  TestInput input{Form::sequence, {}};
  append_random(input.values, static_cast<int>(bounds.usual) + random.between(-spread, spread),
                random);
  return input;
}

}  // namespace jaywalk::search
