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

template <class T>
void put(PointBlob& blob, std::size_t at, T value) {
  std::memcpy(blob.data() + at, &value, sizeof value);
}

}  // namespace

PointBlob point_blob(double x, double y, int srs_id) {
  PointBlob blob{'G', 'P', kVersion1, kLittleEndianNoEnvelope};
  put(blob, 4, static_cast<std::int32_t>(srs_id));
  blob[8] = kLittleEndian;
  put(blob, 9, kWkbPoint);
  put(blob, 13, x);
  put(blob, 21, y);
  return blob;
}

}  // namespace jaywalk
