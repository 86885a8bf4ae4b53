// SPDX-License-Identifier: Apache-2.0
#include "interpreter/actions/functions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "interpreter/actions/actions.h"
#include "interpreter/actions/java/java_text.h"

namespace jaywalk::functions {
namespace {

using Args = std::span<const Value>;

bool one_number(Args args, Value& result, double (*function)(double)) {
  const Value x = deref(args[0]);
  if (!x.is_number()) return false;
  result = Value::number(function(x.as_number()));
  return true;
}

std::vector<double> numbers_in(Value list) {
  std::vector<double> found;
  for (const Value element : actions::elements(list)) {
    if (element.is_number()) found.push_back(element.as_number());
  }
  return found;
}

// All elements must be numbers, and there must be some.
bool all_numbers(Value list, std::vector<double>& found) {
  found = numbers_in(list);
  return !found.empty() && found.size() == actions::elements(list).size();
}

bool extreme(Args args, Value& result, double empty, double (*better)(double, double)) {
  if (args.size() == 1) {
    if (!deref(args[0]).is_list()) return false;
    const std::vector<double> all = numbers_in(args[0]);
    double best = all.empty() ? empty : all.front();
    for (const double x : all) best = better(best, x);
    result = Value::number(best);
    return true;
  }
  const Value x = deref(args[0]);
  const Value y = deref(args[1]);
  if (!x.is_number() || !y.is_number()) return false;
  result = Value::number(better(x.as_number(), y.as_number()));
  return true;
}

// Math.round: halves go up; as a long, so not a number is 0 and large ones are cut.
double java_round(double x) {
  if (std::isnan(x)) return 0;
  constexpr double kLimit = 9223372036854775808.0;
  const double whole = std::floor(x);
  return std::clamp(x - whole >= 0.5 ? whole + 1 : whole, -kLimit, kLimit);
}

// Math.max, Math.min: not a number if one of them is not.
double java_max(double a, double b) {
  return std::isnan(a) || std::isnan(b) ? std::numeric_limits<double>::quiet_NaN() : std::max(a, b);
}
double java_min(double a, double b) {
  return std::isnan(a) || std::isnan(b) ? std::numeric_limits<double>::quiet_NaN() : std::min(a, b);
}

double total(const std::vector<double>& all) {
  double sum = 0;
  for (const double x : all) sum += x;
  return sum;
}

}  // namespace

#define JAYWALK_ONE(name, expression)                                               \
  bool name(Args args, Heap&, SymbolTable&, Value& result) {                        \
    return one_number(args, result, [](double x) -> double { return expression; }); \
  }
JAYWALK_ONE(absolute, std::fabs(x))
JAYWALK_ONE(arc_cosine, std::acos(x))
JAYWALK_ONE(arc_sine, std::asin(x))
JAYWALK_ONE(arc_tangent, std::atan(x))
JAYWALK_ONE(cosine, std::cos(x))
JAYWALK_ONE(sine, std::sin(x))
JAYWALK_ONE(tangent, std::tan(x))
JAYWALK_ONE(ceiling, std::ceil(x))
JAYWALK_ONE(floor_of, std::floor(x))
JAYWALK_ONE(rounded, java_round(x))
JAYWALK_ONE(square_root, std::sqrt(x))
JAYWALK_ONE(logarithm, std::log(x))
#undef JAYWALK_ONE

bool euler(Args, Heap&, SymbolTable&, Value& result) {
  result = Value::number(std::numbers::e);
  return true;
}

bool pi(Args, Heap&, SymbolTable&, Value& result) {
  result = Value::number(std::numbers::pi);
  return true;
}

// Without numbers, Jason's answers: Double.MIN_VALUE, which is above zero, and Double.MAX_VALUE.
bool maximum(Args args, Heap&, SymbolTable&, Value& result) {
  return extreme(args, result, std::numeric_limits<double>::denorm_min(), java_max);
}

bool minimum(Args args, Heap&, SymbolTable&, Value& result) {
  return extreme(args, result, std::numeric_limits<double>::max(), java_min);
}

bool sum(Args args, Heap&, SymbolTable&, Value& result) {
  if (!deref(args[0]).is_list()) return false;
  result = Value::number(total(numbers_in(args[0])));
  return true;
}

bool average(Args args, Heap&, SymbolTable&, Value& result) {
  if (!deref(args[0]).is_list()) return false;
  const std::vector<double> all = numbers_in(args[0]);
  result = Value::number(total(all) / static_cast<double>(all.size()));
  return true;
}

bool mean(Args args, Heap&, SymbolTable&, Value& result) {
  const std::vector<double> all = numbers_in(args[0]);
  if (all.empty()) return false;
  result = Value::number(total(all) / static_cast<double>(all.size()));
  return true;
}

bool median(Args args, Heap&, SymbolTable&, Value& result) {
  std::vector<double> all;
  if (!all_numbers(args[0], all)) return false;
  std::sort(all.begin(), all.end());
  const std::size_t middle = all.size() / 2;
  result = Value::number(all.size() % 2 == 1 ? all[middle] : (all[middle - 1] + all[middle]) / 2);
  return true;
}

bool standard_deviation(Args args, Heap&, SymbolTable&, Value& result) {
  if (!deref(args[0]).is_list()) return false;
  const std::vector<double> all = numbers_in(args[0]);
  const double centre = total(all) / static_cast<double>(all.size());
  double squares = 0;
  for (const double x : all) squares += (x - centre) * (x - centre);
  result = Value::number(std::sqrt(squares / (static_cast<double>(all.size()) - 1)));
  return true;
}

bool length_of(Args args, Heap&, SymbolTable&, Value& result) {
  Value value = deref(args[0]);
  std::size_t length = 0;
  if (value.is_text()) {
    length = actions::utf16_length(value.text()->view());
  } else if (value.is_list()) {
    for (; value.is_pair(); value = deref(value.pair()->tail)) ++length;
  } else if (value.is_object()) {
    length = value.object()->object->size();
  } else {
    return false;
  }
  result = Value::number(static_cast<double>(length));
  return true;
}

}  // namespace jaywalk::functions
