// SPDX-License-Identifier: Apache-2.0
#include "interpreter/actions/java/java_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <fmt/format.h>

#include "interpreter/actions/java/java_text.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {
namespace {

constexpr std::size_t kMostWidth = 100'000;

struct Specifier {
  std::size_t index = 0;  // 1-based; 0: the next one
  bool previous = false;  // %<s
  std::string flags;
  std::size_t width = 0;
  int precision = -1;
  char conversion = 's';
  [[nodiscard]] bool has(char flag) const { return flags.find(flag) != flags.npos; }
};

// The shortest decimal digits of a positive number, 0.d1d2d3... times ten to the exponent.
struct Digits {
  std::string digits;
  int exponent = 0;

  /// Keeps some digits behind the point that the exponent puts, halves away from zero.
  void round_at(int count) {
    if (count >= static_cast<int>(digits.size())) return;
    if (count < 0) {
      digits.clear();
      return;
    }
    const auto place = static_cast<std::size_t>(count);
    const bool up = digits[place] >= '5';
    digits.resize(place);
    if (!up) return;
    std::size_t i = place;
    while (i > 0 && digits[i - 1] == '9') digits[--i] = '0';
    if (i > 0) {
      ++digits[i - 1];
    } else {
      digits.insert(digits.begin(), '1');
      ++exponent;
    }
  }
};

Digits digits_of(double value) {
  if (value == 0) return {"0", 1};
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::scientific);
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data()));
  const std::size_t e = text.find('e');
  Digits result;
  for (const char c : text.substr(0, e)) {
    if (c != '.') result.digits += c;
  }
  result.exponent = std::atoi(text.data() + e + 1) + 1;
  return result;
}

std::string fixed(double value, int precision) {
  Digits d = digits_of(value);
  // Java rounds the shortest decimal digits, not the binary number: 0.125 becomes 0.13.
  d.round_at(d.exponent + precision);
  std::string whole = "0";
  std::string fraction;
  if (d.exponent > 0) {
    whole = d.digits.substr(0, static_cast<std::size_t>(d.exponent));
    whole.resize(static_cast<std::size_t>(d.exponent), '0');
    if (d.digits.size() > whole.size()) fraction = d.digits.substr(whole.size());
  } else {
    fraction.assign(static_cast<std::size_t>(-d.exponent), '0');
    fraction += d.digits;
  }
  fraction.resize(static_cast<std::size_t>(precision), '0');
  return precision > 0 ? fmt::format("{}.{}", whole, fraction) : whole;
}

std::string scientific(double value, int precision) {
  Digits d = digits_of(value);
  d.round_at(precision + 1);
  d.digits.resize(static_cast<std::size_t>(precision) + 1, '0');
  const int exponent = value == 0 ? 0 : d.exponent - 1;
  if (precision > 0) d.digits.insert(1, 1, '.');
  return fmt::format("{}e{}{:02}", d.digits, exponent < 0 ? '-' : '+', std::abs(exponent));
}

std::string general(double value, int precision) {
  if (precision == 0) precision = 1;
  if (value == 0) return fixed(value, precision - 1);
  Digits d = digits_of(value);
  d.round_at(precision);
  // After rounding, as Java decides: from 1e-4 to below ten to the precision.
  if (d.exponent < -3 || d.exponent > precision) return scientific(value, precision - 1);
  return fixed(value, precision - d.exponent);
}

void group_thousands(std::string& text) {
  std::size_t end = text.find_first_not_of("0123456789");
  if (end == text.npos) end = text.size();
  while (end > 3) text.insert(end -= 3, ",");
}

class Formatter {
 public:
  Formatter(std::span<const FormatArgument> args, std::string& out, std::string& error)
      : args_(args), out_(out), error_(error) {}

  bool run(std::string_view format) {
    for (std::size_t i = 0; i < format.size();) {
      if (format[i] != '%') {
        out_ += format[i++];
        continue;
      }
      ++i;
      Specifier specifier;
      if (!read(format, i, specifier) || !write(specifier)) return false;
      if (out_.size() > kMaxTextBytes) return fail("the text is longer than 64 MB");
    }
    return true;
  }

 private:
  bool fail(std::string why) {
    error_ = std::move(why);
    return false;
  }

  static bool number(std::string_view format, std::size_t& i, std::size_t& value) {
    const std::size_t start = i;
    value = 0;
    while (i < format.size() && format[i] >= '0' && format[i] <= '9' && i < start + 8) {
      value = value * 10 + static_cast<std::size_t>(format[i++] - '0');
    }
    return i > start;
  }

  bool read(std::string_view format, std::size_t& i, Specifier& specifier) {
    std::size_t value = 0;
    std::size_t ahead = i;
    // A number is an index only if `$` follows, else it is flags and a width.
    if (ahead < format.size() && format[ahead] == '<') {
      specifier.previous = true;
      ++i;
    } else if (number(format, ahead, value) && ahead < format.size() && format[ahead] == '$') {
      specifier.index = value;
      i = ahead + 1;
    }
    constexpr std::string_view kFlags = "-#+ 0,(";
    while (i < format.size() && kFlags.find(format[i]) != kFlags.npos) {
      specifier.flags += format[i++];
    }
    (void)number(format, i, specifier.width);
    if (i < format.size() && format[i] == '.') {
      ++i;
      if (!number(format, i, value)) return fail("a precision must be a number");
      specifier.precision = static_cast<int>(std::min<std::size_t>(value, kMostWidth + 1));
    }
    if (i >= format.size()) return fail("the format ends within a specifier");
    specifier.conversion = format[i++];
    if (specifier.width > kMostWidth || specifier.precision > static_cast<int>(kMostWidth)) {
      return fail("a width or precision is larger than 100000");
    }
    const bool needs_width = specifier.has('-') || specifier.has('0');
    if (needs_width && specifier.width == 0) return fail("the flags '-' and '0' need a width");
    if (specifier.has('-') && specifier.has('0'))
      return fail("the flags '-' and '0' exclude each other");
    return true;
  }

  bool write(const Specifier& specifier) {
    if (specifier.conversion == 'n') {
      out_ += '\n';
      return true;
    }
    if (specifier.conversion == '%') {
      pad("%", specifier);
      return true;
    }
    const std::size_t index = specifier.previous     ? last_
                              : specifier.index != 0 ? specifier.index
                                                     : ++next_;
    // `%<s` before any other has no previous argument.
    if (index == 0 || index > args_.size()) {
      return fail(fmt::format("there is no argument for %{}", specifier.conversion));
    }
    last_ = index;
    return argument(specifier, args_[index - 1]);
  }

  bool argument(const Specifier& specifier, const FormatArgument& arg) {
    using Kind = FormatArgument::Kind;
    switch (specifier.conversion) {
      case 's':
      case 'S':
        pad(cased(specifier, cut(specifier, arg.text)), specifier);
        return true;
      case 'b':
      case 'B':
        pad(cased(specifier, cut(specifier, arg.kind == Kind::truth ? arg.text : "true")),
            specifier);
        return true;
      case 'h':
      case 'H':
        pad(cased(specifier, fmt::format("{:x}", hash(arg))), specifier);
        return true;
      case 'e':
      case 'E':
      case 'f':
      case 'g':
      case 'G':
        if (arg.kind != Kind::number) break;
        floating(specifier, arg.number);
        return true;
      default:
        break;
    }
    return fail(fmt::format("%{} does not fit {}", specifier.conversion, arg.text));
  }

  static std::string cut(const Specifier& specifier, const std::string& text) {
    if (specifier.precision < 0) return text;
    return std::string(utf16_slice(text, 0, static_cast<std::size_t>(specifier.precision)));
  }

  static std::string cased(const Specifier& specifier, std::string text) {
    const bool upper = specifier.conversion >= 'A' && specifier.conversion <= 'Z';
    return upper ? upper_case_text(text) : text;
  }

  // String.hashCode and Double.hashCode.
  static std::uint32_t hash(const FormatArgument& arg) {
    if (arg.kind == FormatArgument::Kind::number) {
      std::uint64_t bits = 0;
      static_assert(sizeof bits == sizeof arg.number);
      std::copy_n(reinterpret_cast<const char*>(&arg.number), sizeof bits,
                  reinterpret_cast<char*>(&bits));
      return static_cast<std::uint32_t>(bits ^ bits >> 32U);
    }
    std::uint32_t hash = 0;
    for (const char c : arg.text) hash = hash * 31 + static_cast<unsigned char>(c);
    return hash;
  }

  void floating(const Specifier& specifier, double value) {
    const bool negative = std::signbit(value) && !std::isnan(value);
    std::string_view sign = negative             ? specifier.has('(') ? "(" : "-"
                            : specifier.has('+') ? "+"
                            : specifier.has(' ') ? " "
                                                 : "";
    if (std::isnan(value)) sign = "";
    const double size = std::fabs(value);
    std::string text;
    const int precision = specifier.precision < 0 ? 6 : specifier.precision;
    if (!std::isfinite(value)) {
      text = std::isnan(value) ? "NaN" : "Infinity";
    } else if (specifier.conversion == 'f') {
      text = fixed(size, precision);
    } else if (specifier.conversion == 'e' || specifier.conversion == 'E') {
      text = scientific(size, precision);
    } else {
      text = general(size, precision);
    }
    if (specifier.has(',') && std::isfinite(value)) group_thousands(text);
    const std::string_view close = negative && specifier.has('(') ? ")" : "";
    if (specifier.has('0') && std::isfinite(value)) {
      const std::size_t used = sign.size() + text.size() + close.size();
      if (used < specifier.width) text.insert(0, specifier.width - used, '0');
    }
    pad(cased(specifier, fmt::format("{}{}{}", sign, text, close)), specifier);
  }

  void pad(const std::string& text, const Specifier& specifier) {
    const std::size_t length = utf16_length(text);
    const std::size_t blanks = length < specifier.width ? specifier.width - length : 0;
    if (!specifier.has('-')) out_.append(blanks, ' ');
    out_ += text;
    if (specifier.has('-')) out_.append(blanks, ' ');
  }

  std::span<const FormatArgument> args_;
  std::string& out_;
  std::string& error_;
  std::size_t next_ = 0;
  std::size_t last_ = 0;
};

}  // namespace

bool format_as_java(std::string_view format, std::span<const FormatArgument> args, std::string& out,
                    std::string& error) {
  return Formatter(args, out, error).run(format);
}

}  // namespace jaywalk::actions
