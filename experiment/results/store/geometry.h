#pragma once

// Points as a GeoPackage stores them.

#include <array>

namespace jaywalk {

/// A header without envelope and a point in well-known binary, little-endian: OGC 12-128, 2.1.3.
using PointBlob = std::array<unsigned char, 29>;

/// `srs_id`: the spatial reference system of the layer; -1: metres on a plane of its own.
[[nodiscard]] PointBlob point_blob(double x, double y, int srs_id = -1);

}  // namespace jaywalk
