// SPDX-License-Identifier: Apache-2.0
#include "experiment/test_run/controller_notes.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using testing::ElementsAre;

void add(ControllerNotes& notes, std::uint64_t place, const std::string& text) {
  notes.add(place, std::array{text});
}

TEST(ControllerNotes, AreEachSaidOnceWithTheNumberOfTheirTests) {
  ControllerNotes notes;
  for (const std::uint64_t place : {3, 1, 4, 2})
    add(notes, place, place == 4 ? "it hung" : "it died");
  EXPECT_THAT(notes.texts(), ElementsAre("in 3 tests, it died", "in 1 test, it hung"));
}

TEST(ControllerNotes, AreNoneIfNoTestHasOne) {
  ControllerNotes notes;
  notes.add(0, {});
  EXPECT_THAT(notes.texts(), ElementsAre());
}

TEST(ControllerNotes, AreThoseOfTheFirstTestsWhateverTheOrder) {
  const auto texts_of = [](std::array<std::uint64_t, 8> places) {
    ControllerNotes notes;
    for (const std::uint64_t place : places) add(notes, place, fmt::format("note {}", place % 7));
    return notes.texts();
  };
  std::array<std::uint64_t, 8> places{0, 1, 2, 3, 4, 5, 6, 7};
  const auto texts = texts_of(places);
  EXPECT_THAT(texts, ElementsAre("in 2 tests, note 0", "in 1 test, note 1", "in 1 test, note 2",
                                 "in 1 test, note 3", "in 1 test, note 4",
                                 "and 2 other notes about controllers"));
  std::ranges::reverse(places);
  EXPECT_EQ(texts_of(places), texts);
}

}  // namespace
}  // namespace jaywalk
