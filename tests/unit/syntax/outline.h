// SPDX-License-Identifier: Apache-2.0
#pragma once

// Syntax trees in one unambiguous notation for the tests, `(+ X (* 2 Y))`: two trees are equal if
// their outlines are, apart from spans and redundant parentheses.

#include <string>

#include "interpreter/syntax/ast.h"

namespace jaywalk {

[[nodiscard]] std::string outline(const ast::Node& node);
[[nodiscard]] std::string outline(const ast::Formula& formula);
[[nodiscard]] std::string outline(const ast::Plan& plan);
[[nodiscard]] std::string outline(const ast::Component& component);
[[nodiscard]] std::string outline(const ast::File& file);

}  // namespace jaywalk
