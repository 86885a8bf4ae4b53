// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/store/geometry.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include <fmt/format.h>

namespace jaywalk {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

constexpr unsigned char kVersion1 = 0;
constexpr unsigned char kLittleEndianNoEnvelope = 1;
constexpr unsigned char kLittleEndian = 1;
constexpr std::uint32_t kWkbPoint = 1;
constexpr std::uint32_t kWkbLine = 2;
/// Bytes before the coordinates or the number of points.
constexpr std::size_t kBegin = 13;

template <class T>
void put(std::span<unsigned char> blob, std::size_t at, T value) {
  std::memcpy(blob.data() + at, &value, sizeof value);
}

void begin(std::span<unsigned char> blob, int srs_id, std::uint32_t kind) {
  blob[0] = 'G';
  blob[1] = 'P';
  blob[2] = kVersion1;
  blob[3] = kLittleEndianNoEnvelope;
  put(blob, 4, static_cast<std::int32_t>(srs_id));
  blob[8] = kLittleEndian;
  put(blob, 9, kind);
}

}  // namespace

PointBlob point_blob(double x, double y, int srs_id) {
  PointBlob blob{};
  begin(blob, srs_id, kWkbPoint);
  put(std::span(blob), kBegin, x);
  put(std::span(blob), kBegin + sizeof x, y);
  return blob;
}

std::vector<unsigned char> line_blob(std::span<const double> xy) {
  const auto points = static_cast<std::uint32_t>(xy.size() / 2);
  std::vector<unsigned char> blob(kBegin + sizeof points + xy.size_bytes());
  begin(blob, -1, kWkbLine);
  put(std::span(blob), kBegin, points);
  std::memcpy(blob.data() + kBegin + sizeof points, xy.data(), xy.size_bytes());
  return blob;
}

Placement::Placement(const std::optional<Anchor>& anchor) {
  if (!anchor) return;
  srs_id_ = anchor->epsg;
  easting_ = anchor->easting_m;
  northing_ = anchor->northing_m;
  const double bearing = anchor->bearing_deg * std::numbers::pi / 180;
  cosine_ = std::cos(bearing);
  sine_ = std::sin(bearing);
}

std::string Placement::easting_sql() const {
  return fmt::format("({:.17g} + x * {:.17g} + y * {:.17g})", easting_, cosine_, sine_);
}

std::string Placement::northing_sql() const {
  return fmt::format("({:.17g} - x * {:.17g} + y * {:.17g})", northing_, sine_, cosine_);
}

std::string Placement::definition() const {
  // EPSG numbers the zones 1 to 60 from 32601 in the north and from 32701 in the south.
  const bool north = srs_id_ > 32600 && srs_id_ <= 32660;
  const bool south = srs_id_ > 32700 && srs_id_ <= 32760;
  if (!north && !south) return "undefined";
  const int zone = srs_id_ % 100;
  return fmt::format(
      "PROJCS[\"WGS 84 / UTM zone {}{}\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS "
      "84\",6378137,298.257223563,AUTHORITY[\"EPSG\",\"7030\"]],AUTHORITY[\"EPSG\",\"6326\"]],"
      "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433],AUTHORITY[\"EPSG\",\"4326\"]],"
      "PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],"
      "PARAMETER[\"central_meridian\",{}],PARAMETER[\"scale_factor\",0.9996],"
      "PARAMETER[\"false_easting\",500000],PARAMETER[\"false_northing\",{}],UNIT[\"metre\",1],"
      "AXIS[\"Easting\",EAST],AXIS[\"Northing\",NORTH],AUTHORITY[\"EPSG\",\"{}\"]]",
      zone, north ? 'N' : 'S', zone * 6 - 183, north ? 0 : 10'000'000, srs_id_);
}

}  // namespace jaywalk
