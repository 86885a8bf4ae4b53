// SPDX-License-Identifier: Apache-2.0
// The texts of numbers, as Java writes them.

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

constexpr double kLongLimit = 9223372036854775808.0;

// Java's Double.toString: the shortest digits that give the number back, but at least two, which
// makes a difference for the least numbers of all (4.9E-324).
void append_java_double(std::string& out, double value) {
  std::array<char, 40> buffer{};
  char* const limit = buffer.data() + buffer.size();
  auto end = std::to_chars(buffer.data(), limit, value, std::chars_format::scientific);
  if (std::fpclassify(value) == FP_SUBNORMAL &&
      std::string_view(buffer.data(), end.ptr).find('.') == std::string_view::npos) {
    end = std::to_chars(buffer.data(), limit, value, std::chars_format::scientific, 1);
  }
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data()));
  // C++ writes d.ddde+dd; Java wants plain digits from 1e-3 to below 1e7, else d.dddEd.
  const std::size_t exponent_at = text.find('e');
  int exponent = 0;
  const std::string_view exponent_text = text.substr(exponent_at + 1);
  std::from_chars(exponent_text.data() + (exponent_text.front() == '+' ? 1 : 0),
                  exponent_text.data() + exponent_text.size(), exponent);
  std::string_view mantissa = text.substr(0, exponent_at);
  if (mantissa.front() == '-') {
    out += '-';
    mantissa.remove_prefix(1);
  }
  std::string digits(mantissa.substr(0, 1));
  if (mantissa.size() > 2) digits += mantissa.substr(2);
  const auto count = static_cast<int>(digits.size());
  if (exponent < -3 || exponent >= 7) {
    out += digits[0];
    out += '.';
    out += count > 1 ? digits.substr(1) : "0";
    out += fmt::format("E{}", exponent);
  } else if (exponent < 0) {
    out += "0.";
    out.append(static_cast<std::size_t>(-exponent - 1), '0');
    out += digits;
  } else {
    const auto whole = static_cast<std::size_t>(exponent) + 1;
    if (digits.size() <= whole) digits.append(whole - digits.size() + 1, '0');
    out.append(digits, 0, whole);
    out += '.';
    out.append(digits, whole);
  }
}

}  // namespace

void append_number(std::string& out, double value) {
  if (std::isnan(value)) {
    out += "NaN";
  } else if (std::isinf(value)) {
    out += value > 0 ? "Infinity" : "-Infinity";
  } else if (value == std::floor(value) && std::fabs(value) < kLongLimit) {
    out += fmt::format("{}", static_cast<std::int64_t>(value));
  } else if (value == kLongLimit) {
    out += "9223372036854775807";  // Math.round saturates
  } else if (value == -kLongLimit) {
    out += "-9223372036854775808";
  } else {
    append_java_double(out, value);
  }
}

std::string number_text(double value) {
  std::string out;
  append_number(out, value);
  return out;
}

}  // namespace jaywalk
