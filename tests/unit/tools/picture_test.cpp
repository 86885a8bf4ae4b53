// SPDX-License-Identifier: Apache-2.0
#include <gif_lib.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/crossing/world.h"
#include "tools/picture/gif.h"
#include "tools/picture/test_picture.h"

namespace jaywalk::picture {
namespace {

/// The AV drives 9 m in a second; a pedestrian crosses before it and is met at tick 2.
Recording crossing() {
  Recording recording(1, {{.name = "av", .kind = ActorKind::vehicle, .length_m = 4.5, .width_m = 3},
                          {.name = "p1", .length_m = 0.5, .width_m = 0.5}});
  for (const double t : {0.0, 1.0, 2.0}) {
    recording.add(
        std::vector<ActorState>{{6, 9 * t, 9, 1.5707963267948966}, {1.5 + 1.5 * t, 24, 1.5, 0}});
  }
  recording.add({.tick = 2, .actor = 1, .kind = "precondition", .text = ""});
  return recording;
}

std::uint32_t pixel(const Image& image, double x, double y) {
  return image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                      static_cast<std::size_t>(x)];
}

bool is_dark(std::uint32_t colour) {
  return (colour & 0xFFU) < 80 && ((colour >> 16U) & 0xFFU) < 80;
}

TEST(TestPicture, ShowsTheAvWhereItIs) {
  const CrossingParameters world;
  const Recording recording = crossing();
  const TestPicture picture("a test", CrossingSpec(world).plan(), recording);
  // 99 m are drawn on 928 pixels, from 16 pixels on; rows begin 64 pixels below the upper edge.
  const double scale = 928.0 / 99;
  for (const std::size_t tick : {0U, 1U, 2U}) {
    const Image image = picture.draw(tick).image();
    EXPECT_EQ(image.width, 960);
    for (const std::size_t other : {1U, 2U}) {
      const double x = 16 + 9.0 * static_cast<double>(other) * scale;
      EXPECT_EQ(is_dark(pixel(image, x, 64 + 5 * scale)), other == tick) << tick << ' ' << other;
    }
  }
}

TEST(TestPicture, ColoursWhoMetThePrecondition) {
  const CrossingParameters world;
  const Recording recording = crossing();
  const TestPicture picture("a test", CrossingSpec(world).plan(), recording);
  const double scale = 928.0 / 99;
  const auto red_of = [&](std::size_t tick, double x_m) {
    return (pixel(picture.draw(tick).image(), 16 + 24 * scale, 64 + x_m * scale) >> 16U) & 0xFFU;
  };
  EXPECT_LT(red_of(1, 3), 40U);     // blue
  EXPECT_GT(red_of(2, 4.5), 180U);  // vermilion
}

TEST(TestPicture, FollowsTheAvOnALongRoad) {
  CrossingParameters world;
  world.length = 2000;
  Recording recording(1,
                      {{.name = "av", .kind = ActorKind::vehicle, .length_m = 4.5, .width_m = 3}});
  recording.add(std::vector<ActorState>{{6, 1500, 9, 1.5707963267948966}});
  const Image image = TestPicture("far", CrossingSpec(world).plan(), recording).draw(0).image();
  EXPECT_TRUE(is_dark(pixel(image, 16 + 928.0 / 3, 64 + 5 * 928.0 / 160)));
}

TEST(TestPicture, IsWrittenAsPng) {
  const CrossingParameters world;
  const Recording recording = crossing();
  const std::string png =
      TestPicture("a test", CrossingSpec(world).plan(), recording).draw(0).png();
  EXPECT_THAT(png, testing::StartsWith("\x89PNG\r\n"));
  EXPECT_EQ(png, TestPicture("a test", CrossingSpec(world).plan(), recording).draw(0).png());
}

struct CloseInput {
  void operator()(GifFileType* file) const { DGifCloseFile(file, nullptr); }
};

TEST(Gif, IsReadBackFrameByFrame) {
  const std::array<std::uint32_t, 3> colours = {0xFF0000, 0x00FF00, 0x0000FF};
  std::string bytes = to_gif({.frames = 3,
                              .frame =
                                  [&](int frame) {
                                    return Image{.width = 5,
                                                 .height = 4,
                                                 .pixels = std::vector<std::uint32_t>(
                                                     20, colours[static_cast<std::size_t>(frame)])};
                                  },
                              .frame_s = 0.25,
                              .last_s = 1});
  std::string_view rest = bytes;
  const auto read = [](GifFileType* file, GifByteType* target, int wanted) {
    auto& from = *static_cast<std::string_view*>(file->UserData);
    const std::size_t count = std::min(from.size(), static_cast<std::size_t>(wanted));
    std::copy_n(from.begin(), count, target);
    from.remove_prefix(count);
    return static_cast<int>(count);
  };
  const std::unique_ptr<GifFileType, CloseInput> file(DGifOpen(&rest, read, nullptr));
  ASSERT_NE(file, nullptr);
  ASSERT_EQ(DGifSlurp(file.get()), GIF_OK);
  EXPECT_EQ(file->SWidth, 5);
  EXPECT_EQ(file->SHeight, 4);
  ASSERT_EQ(file->ImageCount, 3);
  for (int frame = 0; frame < 3; ++frame) {
    GraphicsControlBlock control{};
    ASSERT_EQ(DGifSavedExtensionToGCB(file.get(), frame, &control), GIF_OK);
    EXPECT_EQ(control.DelayTime, frame == 2 ? 100 : 25);
    const GifColorType colour = file->SColorMap->Colors[file->SavedImages[frame].RasterBits[7]];
    EXPECT_EQ(colour.Red > 200, frame == 0);
    EXPECT_EQ(colour.Green > 200, frame == 1);
    EXPECT_EQ(colour.Blue > 200, frame == 2);
  }
}

}  // namespace
}  // namespace jaywalk::picture
