#include "experiment/results/store/geometry.h"

#include <bit>
#include <cstdint>
#include <cstring>

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

}  // namespace jaywalk
