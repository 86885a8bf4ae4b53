#include "search/test_input.h"

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

}  // namespace jaywalk::search
