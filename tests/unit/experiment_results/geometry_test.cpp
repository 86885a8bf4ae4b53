// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/store/geometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/results/store/schema.h"
#include "experiment/scenario/files/program_text.h"

namespace jaywalk {
namespace {

TEST(PointBlob, IsAHeaderAndAWellKnownBinaryPoint) {
  const PointBlob blob = point_blob(1, -2);
  EXPECT_THAT(blob, testing::ElementsAre('G', 'P', 0, 1, 0xFF, 0xFF, 0xFF, 0xFF,  // srs -1
                                         1, 1, 0, 0, 0,                           // a point
                                         0, 0, 0, 0, 0, 0, 0xF0, 0x3F,            // 1
                                         0, 0, 0, 0, 0, 0, 0x00, 0xC0));          // -2
}

TEST(LineBlob, IsAHeaderAndAWellKnownBinaryLine) {
  const std::vector<double> xy{1, -2, 3, 4};
  const std::vector<unsigned char> blob = line_blob(xy);
  ASSERT_EQ(blob.size(), 13 + 4 + 4 * sizeof(double));
  EXPECT_THAT(std::vector<unsigned char>(blob.begin(), blob.begin() + 25),
              testing::ElementsAre('G', 'P', 0, 1, 0xFF, 0xFF, 0xFF, 0xFF,  // srs -1
                                   1, 2, 0, 0, 0,                           // a line
                                   2, 0, 0, 0,                              // of two points
                                   0, 0, 0, 0, 0, 0, 0xF0, 0x3F));          // 1
}

TEST(Sha256, IsThatOfTheStandard) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(TimeText, CountsFromTheMomentOfTick0) {
  EXPECT_EQ(time_text(0), "2000-01-01T00:00:00.000Z");
  EXPECT_EQ(time_text(12.5), "2000-01-01T00:00:12.500Z");
  EXPECT_EQ(time_text(86400 * 60), "2000-03-01T00:00:00.000Z");
  EXPECT_EQ(time_text(1e300).size(), time_text(0).size());
}

}  // namespace
}  // namespace jaywalk
