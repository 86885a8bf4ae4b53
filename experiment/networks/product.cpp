// SPDX-License-Identifier: Apache-2.0
// Both factors are copied to where the innermost loop reads them from end to end, then tiles of two
// vector registers by four columns are computed (Goto and van de Geijn 2008, "Anatomy of
// high-performance matrix multiplication"). Eigen does the same, but only with the registers that
// every processor has; here the wider ones are taken where there are any. Not fused multiply-add,
// which rounds once where others round twice.

#include "experiment/networks/product.h"

#include <algorithm>
#include <cstring>
#include <vector>

#if defined(__x86_64__)
#define JAYWALK_HAS_WIDE_LANES 1
#else
#define JAYWALK_HAS_WIDE_LANES 0
#endif

namespace jaywalk::networks {
namespace {

using Eigen::Index;

/// Columns of a tile.
constexpr Index kTileColumns = 4;

template <Index width>
struct LanesOf {
  typedef float Type __attribute__((vector_size(static_cast<std::size_t>(width) * sizeof(float))));
};

constexpr Index rounded_up(Index count, Index step) { return (count + step - 1) / step * step; }

/// One strip, by columns; columns beyond the factor's are filled with zeros.
template <Index height>
void pack_strip(const Factor& factor, Index first, float* strip) {
  const Index depth = factor.columns;
  const Index rows = std::min(height, factor.rows - first);
  const float* const from = factor.data + first * factor.down;
  if (rows < height) std::fill_n(strip, height * depth, 0.0F);
  if (factor.down == 1 && rows == height) {
    for (Index k = 0; k < depth; ++k) {
      std::memcpy(strip + k * height, from + k * factor.right, height * sizeof(float));
    }
    return;
  }
  for (Index row = 0; row < rows; ++row) {
    const float* number = from + row * factor.down;
    for (Index k = 0; k < depth; ++k, number += factor.right) strip[k * height + row] = *number;
  }
}

/// Strips of `height` rows one after another.
template <Index height>
void pack(const Factor& factor, std::vector<float>& packed) {
  const auto size = static_cast<std::size_t>(rounded_up(factor.rows, height) * factor.columns);
  if (packed.size() < size) packed.resize(size);
  float* strip = packed.data();
  for (Index first = 0; first < factor.rows; first += height, strip += height * factor.columns) {
    pack_strip<height>(factor, first, strip);
  }
}

/// Adds the product of a strip of two registers' rows and one of four columns to where `sum`
/// points.
template <Index width>
[[gnu::always_inline]] inline void add_tile(const float* a, const float* b, Index depth, float* sum,
                                            Index stride, Index columns) {
  using Lanes = typename LanesOf<width>::Type;
  Lanes upper[kTileColumns];
  Lanes lower[kTileColumns];
  for (Index column = 0; column < kTileColumns; ++column) {
    upper[column] = Lanes{};
    lower[column] = Lanes{};
  }
  for (Index k = 0; k < depth; ++k, a += 2 * width, b += kTileColumns) {
    Lanes above;
    Lanes below;
    std::memcpy(&above, a, sizeof above);
    std::memcpy(&below, a + width, sizeof below);
    for (Index column = 0; column < kTileColumns; ++column) {
      upper[column] += above * b[column];
      lower[column] += below * b[column];
    }
  }
  for (Index column = 0; column < kTileColumns && column < columns; ++column, sum += stride) {
    Lanes above;
    Lanes below;
    std::memcpy(&above, sum, sizeof above);
    std::memcpy(&below, sum + width, sizeof below);
    above += upper[column];
    below += lower[column];
    std::memcpy(sum, &above, sizeof above);
    std::memcpy(sum + width, &below, sizeof below);
  }
}

/// The product of packed strips. REQUIRES: the rows are a multiple of kRowsOfTiles.
template <Index width>
[[gnu::always_inline]] inline void add_tiles(const float* left, const float* right, Index depth,
                                             Eigen::MatrixXf& sum) {
  const Index stride = sum.rows();
  for (Index row = 0; row < sum.rows(); row += 2 * width, left += 2 * width * depth) {
    for (Index column = 0; column < sum.cols(); column += kTileColumns) {
      add_tile<width>(left, right + column * depth, depth, sum.data() + row + column * stride,
                      stride, std::min(kTileColumns, sum.cols() - column));
    }
  }
}

void add_narrow_tiles(const float* left, const float* right, Index depth, Eigen::MatrixXf& sum) {
  add_tiles<4>(left, right, depth, sum);
}

#if JAYWALK_HAS_WIDE_LANES
[[gnu::target("avx2")]] void add_wide_tiles(const float* left, const float* right, Index depth,
                                            Eigen::MatrixXf& sum) {
  add_tiles<8>(left, right, depth, sum);
}
bool has_wide_lanes() {
  static const bool has = __builtin_cpu_supports("avx2") != 0;
  return has;
}
#endif

}  // namespace

void fix_order_of_sums() {
  // Set once, before any other thread can multiply: every multiplication calls this first.
  static const bool is_fixed = [] {
    constexpr std::ptrdiff_t kKilobyte = 1024;
    Eigen::setCpuCacheSizes(32 * kKilobyte, 512 * kKilobyte, 4096 * kKilobyte);
    return true;
  }();
  (void)is_fixed;
}

void add_tiled_product(const Factor& a, const Factor& b, Eigen::MatrixXf& sum) {
  // Memory alone: nothing is read that this call has not written.
  static thread_local std::vector<float> left;
  static thread_local std::vector<float> right;
  const Factor columns{b.data, b.columns, b.rows, b.right, b.down};
  pack<kTileColumns>(columns, right);
#if JAYWALK_HAS_WIDE_LANES
  if (has_wide_lanes()) {
    pack<16>(a, left);
    add_wide_tiles(left.data(), right.data(), a.columns, sum);
    return;
  }
#endif
  pack<8>(a, left);
  add_narrow_tiles(left.data(), right.data(), a.columns, sum);
}

}  // namespace jaywalk::networks
