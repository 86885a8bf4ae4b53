#include "experiment/compare/csv_fields.h"

#include <fmt/format.h>

namespace jaywalk {
namespace {

std::string six_decimals(double value) {
  std::string text = fmt::format("{:.6f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace

void add_csv_field(std::string& line, std::optional<double> value) {
  line += ',';
  if (value) line += six_decimals(*value);
}

}  // namespace jaywalk
