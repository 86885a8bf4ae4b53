// SPDX-License-Identifier: Apache-2.0
#include "env/vehicle/defects.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "env/vehicle/defects/defective.h"

namespace jaywalk {

namespace {

namespace severities_of {

#define JAYWALK_DEFECT(name, family, unit, function, summary, source, ...) \
  constexpr auto function = std::to_array<double>({__VA_ARGS__});
#include "env/vehicle/defects.def"
#undef JAYWALK_DEFECT

}  // namespace severities_of

std::optional<double> positive_number(std::string_view text) {
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (!std::isfinite(value) || value <= 0) return std::nullopt;
  return value;
}

}  // namespace

std::string_view name(DefectFamily family) {
  switch (family) {
    case DefectFamily::perception:
      return "perception";
    case DefectFamily::prediction:
      return "prediction";
    case DefectFamily::decision:
      return "decision";
    case DefectFamily::actuation:
      return "actuation";
  }
  return {};
}

std::span<const DefectModel> defect_models() {
#define JAYWALK_DEFECT(name, family, unit, function, summary, source, ...) \
  DefectModel{name, DefectFamily::family, unit, severities_of::function, summary, source, function},
  static const std::array kModels{
#include "env/vehicle/defects.def"
  };
#undef JAYWALK_DEFECT
  return kModels;
}

const DefectModel* find_defect(std::string_view name) {
  const std::span<const DefectModel> all = defect_models();
  const auto found = std::ranges::find(all, name, &DefectModel::name);
  return found == all.end() ? nullptr : &*found;
}

std::optional<VehicleDefect> parse_defect(std::string_view text) {
  const std::size_t equals = text.find('=');
  const DefectModel* const model = find_defect(text.substr(0, equals));
  if (model == nullptr) return std::nullopt;
  VehicleDefect defect{std::string(model->name), model->severities.front()};
  if (equals == std::string_view::npos) return defect;
  const std::optional<double> severity = positive_number(text.substr(equals + 1));
  if (!severity || model->unit.empty()) return std::nullopt;
  if (model->unit == "%" && *severity > 100) return std::nullopt;
  defect.severity = *severity;
  return defect;
}

std::string text_of(const VehicleDefect& defect) {
  const DefectModel* const model = find_defect(defect.name);
  if (model != nullptr && model->unit.empty()) return defect.name;
  return fmt::format("{}={}", defect.name, defect.severity);
}

std::unique_ptr<VehicleController> with_defects(std::unique_ptr<VehicleController> controller,
                                                std::span<const VehicleDefect> defects) {
  if (!controller) return nullptr;
  for (const VehicleDefect& each : defects) {
    const DefectModel* const model = find_defect(each.name);
    assert(model != nullptr && "scenarios name defects that exist");
    controller = model->make(std::move(controller), each.severity);
  }
  return controller;
}

}  // namespace jaywalk
