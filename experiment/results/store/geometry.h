#pragma once

// Points and lines as a GeoPackage stores them: a header without envelope and well-known binary,
// little-endian (OGC 12-128, 2.1.3).

#include <array>
#include <span>
#include <vector>

namespace jaywalk {

using PointBlob = std::array<unsigned char, 29>;

/// `srs_id`: the spatial reference system of the layer; -1: metres on a plane of its own.
[[nodiscard]] PointBlob point_blob(double x, double y, int srs_id = -1);

/// A line through points x, y, x, y, … on a plane of its own. REQUIRES: there are some.
[[nodiscard]] std::vector<unsigned char> line_blob(std::span<const double> xy);

}  // namespace jaywalk
