// SPDX-License-Identifier: Apache-2.0
#pragma once

// The building blocks of the grammar (grammar.cpp): parsers in Boost.Spirit X3 that match tokens
// instead of characters, or match nothing and call the builder. Errors use their names, "expected
// …".

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include <boost/spirit/home/x3.hpp>

#include "interpreter/syntax/builder.h"
#include "interpreter/syntax/lexer.h"

namespace jaywalk::grammar {

namespace x3 = boost::spirit::x3;

using Iterator = const Token*;

struct BuilderTag;

template <class Context>
Builder& builder_of(const Context& context) {
  return x3::get<BuilderTag>(context);
}

constexpr std::uint64_t bit(TokenKind kind) {
  return std::uint64_t{1} << static_cast<unsigned>(kind);
}
static_assert(static_cast<unsigned>(TokenKind::power) < 64, "sets of token kinds have 64 bits");

template <class... Kinds>
constexpr std::uint64_t set_of(Kinds... kinds) {
  return (bit(kinds) | ...);
}

// Matches one token of a set of kinds. The name is for diagnostics; a single kind has one already.
struct Terminal : x3::parser<Terminal> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;

  std::uint64_t kinds;
  std::string_view name;

  explicit Terminal(TokenKind kind) : kinds(bit(kind)), name(name_of(kind)) {}
  constexpr Terminal(std::uint64_t set, std::string_view called) : kinds(set), name(called) {}

  template <class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& /*last*/, const Context& context,
             RuleContext& /*unused*/, Attribute& /*unused*/) const {
    if ((kinds & bit(first->kind)) == 0) return false;
    builder_of(context).consume(*first);
    ++first;
    return true;
  }
};

constexpr std::uint64_t kAny = ~std::uint64_t{0};

// Looks at one token, or two, without consuming it.
struct Ahead : x3::parser<Ahead> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;

  std::uint64_t kinds;
  std::uint64_t second;
  std::string_view name;

  constexpr Ahead(std::uint64_t set, std::string_view called) : Ahead(set, kAny, called) {}
  constexpr Ahead(std::uint64_t set, std::uint64_t second_set, std::string_view called)
      : kinds(set), second(second_set), name(called) {}

  template <class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& /*last*/, const Context& /*context*/,
             RuleContext& /*unused*/, Attribute& /*unused*/) const {
    if ((kinds & bit(first->kind)) == 0) return false;
    return second == kAny || (second & bit(first[1].kind)) != 0;
  }
};

// Calls a method of the builder; one that returns false makes the parse fail here.
template <auto Method>
struct Do : x3::parser<Do<Method>> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;

  template <class Context, class RuleContext, class Attribute>
  bool parse(Iterator& /*first*/, const Iterator& /*last*/, const Context& context,
             RuleContext& /*unused*/, Attribute& /*unused*/) const {
    Builder& builder = builder_of(context);
    if constexpr (std::is_void_v<decltype((builder.*Method)())>) {
      (builder.*Method)();
      return true;
    } else {
      return (builder.*Method)();
    }
  }
};

template <auto Method>
constexpr Do<Method> act{};

}  // namespace jaywalk::grammar

// The names in "expected ..." of parsers that have no name of their own.
namespace boost::spirit::x3 {

template <>
struct get_info<jaywalk::grammar::Terminal> {
  using result_type = std::string;
  std::string operator()(const jaywalk::grammar::Terminal& parser) const {
    return std::string(parser.name);
  }
};

template <>
struct get_info<jaywalk::grammar::Ahead> {
  using result_type = std::string;
  std::string operator()(const jaywalk::grammar::Ahead& parser) const {
    return std::string(parser.name);
  }
};

template <class Left, class Right>
struct get_info<sequence<Left, Right>> {
  using result_type = std::string;
  std::string operator()(const sequence<Left, Right>& parser) const { return what(parser.left); }
};

template <class Left, class Right>
struct get_info<alternative<Left, Right>> {
  using result_type = std::string;
  std::string operator()(const alternative<Left, Right>& parser) const {
    return what(parser.left) + " or " + what(parser.right);
  }
};

template <class Subject>
struct get_info<expect_directive<Subject>> {
  using result_type = std::string;
  std::string operator()(const expect_directive<Subject>& parser) const {
    return what(parser.subject);
  }
};

template <class Subject>
struct get_info<plus<Subject>> {
  using result_type = std::string;
  std::string operator()(const plus<Subject>& parser) const { return what(parser.subject); }
};

}  // namespace boost::spirit::x3
