// SPDX-License-Identifier: Apache-2.0
#include "experiment/export/exporter.h"

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

TEST(RunProgram, SaysHowTheProgramEnded) {
  EXPECT_EQ(run_program({"true"}), 0);
  EXPECT_EQ(run_program({"sh", "-c", "exit 3"}), 3);
}

TEST(RunProgram, SaysThatThereIsNoneOfThatName) {
  EXPECT_EQ(run_program({"no-such-program-anywhere"}), 127);
}

TEST(RunProgram, CollectsWhatIsWritten) {
  std::string output = "before ";
  EXPECT_EQ(run_program({"printf", "%s-%s", "a b", "$HOME"}, &output), 0);
  EXPECT_EQ(output, "before a b-$HOME") << "no shell reads the words";
}

}  // namespace
}  // namespace jaywalk
