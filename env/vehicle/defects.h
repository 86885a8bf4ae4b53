// SPDX-License-Identifier: Apache-2.0
#pragma once

// Defects: documented faults that are put on a controller, so that tests can be measured by what
// they find. The same controller without them is the healthy twin. Defects are the rows of
// defects.def; another one is a class in a file of the folder `defects` and a row. Read vehicle.h
// before.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "env/vehicle/vehicle.h"

namespace jaywalk {

/// The part of the chain from sensors to wheels in which the fault is.
enum class DefectFamily { perception, prediction, decision, actuation };

[[nodiscard]] std::string_view name(DefectFamily family);

/// A row of defects.def.
struct DefectModel {
  std::string_view name;
  DefectFamily family = DefectFamily::perception;
  /// Unit of the severity: s, m, m/s, m/s2, deg, g (the acceleration of free fall) or %. Empty if
  /// the defect has no degrees; its one severity is 1 then.
  std::string_view unit;
  /// The usual severities, from the mildest; the first one is the default.
  std::span<const double> severities;
  std::string_view summary;
  /// The public report it is known from, or that it is constructed.
  std::string_view source;
  /// Puts it on a controller.
  std::unique_ptr<VehicleController> (*make)(std::unique_ptr<VehicleController> inner,
                                             double severity);
};

/// In the order of their families.
[[nodiscard]] std::span<const DefectModel> defect_models();
/// Null if there is none of that name.
[[nodiscard]] const DefectModel* find_defect(std::string_view name);

/// Out of `latency` (with the row's default severity) or `latency=0.6`. Empty unless the row
/// exists, has a unit if a severity is given, and that is a positive finite number (of per cent,
/// 100 at most).
[[nodiscard]] std::optional<VehicleDefect> parse_defect(std::string_view text);
/// The inverse, with the severity wherever the row has a unit: `latency=0.3`, `blind-left`.
[[nodiscard]] std::string text_of(const VehicleDefect& defect);

/// Puts defects on a controller, the first one next to it. Null stays null.
/// REQUIRES: the defects exist.
[[nodiscard]] std::unique_ptr<VehicleController> with_defects(
    std::unique_ptr<VehicleController> controller, std::span<const VehicleDefect> defects);

}  // namespace jaywalk
