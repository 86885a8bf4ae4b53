// SPDX-License-Identifier: Apache-2.0
#include "tools/picture/gif.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gif_lib.h>
#include <map>
#include <memory>

namespace jaywalk::picture {
namespace {

constexpr std::size_t kColours = 256;

/// The colours that most pixels have, distinguished by the upper five bits of each part: pictures
/// of few flat colours lose nothing but shades at edges.
class Palette {
 public:
  explicit Palette(const Movie& movie) {
    std::map<std::uint32_t, std::uint64_t> seen;
    for (int frame = 0; frame < movie.frames; ++frame) {
      const Image image = movie.frame(frame);
      for (const std::uint32_t pixel : image.pixels) ++seen[pixel & kUpper];
    }
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    for (const auto& [colour, count] : seen) order.emplace_back(count, colour);
    std::ranges::stable_sort(order, std::greater<>(),
                             &std::pair<std::uint64_t, std::uint32_t>::first);
    order.resize(std::min(order.size(), kColours));
    for (const auto& [count, colour] : order) colours_.push_back(colour);
  }

  [[nodiscard]] GifByteType nearest(std::uint32_t pixel) {
    const std::uint32_t colour = pixel & kUpper;
    const auto known = numbers_.find(colour);
    if (known != numbers_.end()) return known->second;
    const auto distance = [&](std::uint32_t other) {
      int sum = 0;
      for (const unsigned shift : {0U, 8U, 16U}) {
        const int part = static_cast<int>((colour >> shift) & 0xFFU) -
                         static_cast<int>((other >> shift) & 0xFFU);
        sum += part * part;
      }
      return sum;
    };
    const auto found = std::ranges::min_element(colours_, {}, distance);
    const auto number = static_cast<GifByteType>(found - colours_.begin());
    numbers_[colour] = number;
    return number;
  }

  /// As giflib takes it: a power of two of them.
  [[nodiscard]] std::array<GifColorType, kColours> colours() const {
    std::array<GifColorType, kColours> all{};
    for (std::size_t i = 0; i < colours_.size(); ++i) {
      const auto part = [&](unsigned shift) {
        const std::uint32_t upper = (colours_[i] >> shift) & 0xF8U;
        return static_cast<GifByteType>(upper | (upper >> 5U));
      };
      all[i] = {part(16), part(8), part(0)};
    }
    return all;
  }

 private:
  static constexpr std::uint32_t kUpper = 0xF8F8F8U;

  std::vector<std::uint32_t> colours_;
  std::map<std::uint32_t, GifByteType> numbers_;
};

int append(GifFileType* file, const GifByteType* bytes, int length) {
  static_cast<std::string*>(file->UserData)->append(bytes, bytes + length);
  return length;
}

struct CloseFile {
  void operator()(GifFileType* file) const { EGifCloseFile(file, nullptr); }
};
struct FreeMap {
  void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};

/// Netscape's extension: shown again without end.
bool put_loop(GifFileType* file) {
  constexpr std::array<GifByteType, 11> kName = {'N', 'E', 'T', 'S', 'C', 'A',
                                                 'P', 'E', '2', '.', '0'};
  constexpr std::array<GifByteType, 3> kForEver = {1, 0, 0};
  return EGifPutExtensionLeader(file, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
         EGifPutExtensionBlock(file, static_cast<int>(kName.size()), kName.data()) == GIF_OK &&
         EGifPutExtensionBlock(file, static_cast<int>(kForEver.size()), kForEver.data()) ==
             GIF_OK &&
         EGifPutExtensionTrailer(file) == GIF_OK;
}

bool put_delay(GifFileType* file, double seconds) {
  constexpr double kHundredths = 100;
  const auto delay =
      static_cast<unsigned>(std::clamp(std::lround(seconds * kHundredths), 2L, 65535L));
  const std::array<GifByteType, 4> block = {0, static_cast<GifByteType>(delay & 0xFFU),
                                            static_cast<GifByteType>(delay >> 8U), 0};
  return EGifPutExtension(file, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(block.size()),
                          block.data()) == GIF_OK;
}

bool put_frame(GifFileType* file, const Image& image, Palette& palette) {
  if (EGifPutImageDesc(file, 0, 0, image.width, image.height, false, nullptr) != GIF_OK) {
    return false;
  }
  const auto width = static_cast<std::size_t>(image.width);
  std::vector<GifByteType> line(width);
  for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
    for (std::size_t x = 0; x < width; ++x)
      line[x] = palette.nearest(image.pixels[row * width + x]);
    if (EGifPutLine(file, line.data(), image.width) != GIF_OK) return false;
  }
  return true;
}

}  // namespace

std::string to_gif(const Movie& movie) {
  const Image first = movie.frame(0);
  Palette palette(movie);
  std::string bytes;
  const std::unique_ptr<ColorMapObject, FreeMap> map(
      GifMakeMapObject(static_cast<int>(kColours), palette.colours().data()));
  std::unique_ptr<GifFileType, CloseFile> file(EGifOpen(&bytes, append, nullptr));
  if (!map || !file) return {};
  EGifSetGifVersion(file.get(), true);
  bool well = EGifPutScreenDesc(file.get(), first.width, first.height, 8, 0, map.get()) == GIF_OK &&
              put_loop(file.get());
  for (int frame = 0; frame < movie.frames && well; ++frame) {
    const bool last = frame + 1 == movie.frames;
    well = put_delay(file.get(), last ? movie.last_s : movie.frame_s) &&
           put_frame(file.get(), movie.frame(frame), palette);
  }
  file.reset();  // writes the end
  return well ? bytes : std::string();
}

}  // namespace jaywalk::picture
