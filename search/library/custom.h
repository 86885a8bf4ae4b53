// SPDX-License-Identifier: Apache-2.0
#pragma once

// Systems under test and generators of other programs, as the search has them.

#include <memory>
#include <string>
#include <vector>

#include "search/generator.h"
#include "search/sut.h"
#include <jaywalk/generator.h>
#include <jaywalk/system.h>

namespace jaywalk::search {

[[nodiscard]] std::shared_ptr<const SutModel> model_of(SystemUnderTest system);
/// REQUIRES: the name outlives it.
[[nodiscard]] GeneratorKind kind_of(const CustomGenerator& generator);

}  // namespace jaywalk::search
