// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where a store's points lie, and points and lines as a GeoPackage stores them: a header without
// envelope and well-known binary, little-endian (OGC 12-128, 2.1.3).

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "experiment/scenario/scenario.h"

namespace jaywalk {

using PointBlob = std::array<unsigned char, 29>;

/// `srs_id`: the spatial reference system of the layer; -1: metres on a plane of its own.
[[nodiscard]] PointBlob point_blob(double x, double y, int srs_id = -1);

/// A line through points x, y, x, y, … on a plane of its own. REQUIRES: there are some.
[[nodiscard]] std::vector<unsigned char> line_blob(std::span<const double> xy);

/// On a plane of its own, or where the scenario's anchor puts it.
class Placement {
 public:
  explicit Placement(const std::optional<Anchor>& anchor);

  /// -1 (undefined Cartesian) or an EPSG code.
  [[nodiscard]] int srs_id() const { return srs_id_; }
  [[nodiscard]] std::pair<double, double> place(double x_m, double y_m) const {
    return {easting_ + x_m * cosine_ + y_m * sine_, northing_ - x_m * sine_ + y_m * cosine_};
  }
  /// SQL expressions for easting and northing, computed from the columns x and y.
  [[nodiscard]] std::string easting_sql() const;
  [[nodiscard]] std::string northing_sql() const;
  /// Well-known text (OGC 01-009) of the reference system if it is a UTM zone of WGS 84; otherwise
  /// `undefined`, and readers look the EPSG code up.
  [[nodiscard]] std::string definition() const;

 private:
  int srs_id_ = -1;
  double easting_ = 0;
  double northing_ = 0;
  double cosine_ = 1;
  double sine_ = 0;
};

}  // namespace jaywalk
