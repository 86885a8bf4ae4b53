// SPDX-License-Identifier: Apache-2.0
#include "search/test_input.h"

#include <algorithm>

#include <fmt/ranges.h>

namespace jaywalk::search {

std::string_view name(Form form) {
  switch (form) {
    case Form::vector:
      return "vector";
    case Form::sequence:
      return "sequence";
    case Form::points:
      return "points";
  }
  return {};
}

std::string SearchSpace::describe(const TestInput& input) const {
  return fmt::format("{:.4g}", fmt::join(input.values, " "));
}

std::optional<Form> parse_form(std::string_view text) {
  for (const Form form : {Form::vector, Form::sequence, Form::points}) {
    if (text == name(form)) return form;
  }
  return std::nullopt;
}

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
