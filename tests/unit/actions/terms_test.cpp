// SPDX-License-Identifier: Apache-2.0
// Types, annotations and copies.

#include <gtest/gtest.h>

#include "tests/unit/actions/bodies.h"

namespace jaywalk::test {
namespace {

TEST(TypeActions, NameEachTypeInTurn) {
  const auto types = [](const std::string& term, const std::string& expected) {
    return BodyRow{"T = [" + term + "]; T = [X]; .findall(K, .type(X, K), L); .print(L)",
                   {expected}};
  };
  expect_lines({
      types("7", "[number,ground]"),
      types("tea", "[atom,literal,ground]"),
      types("~tea", "[literal,structure,ground]"),
      types("tea[hot]", "[literal,structure,ground]"),
      types("f(1)", "[literal,structure,ground]"),
      types("f(Y)", "[literal,structure]"),
      types("\"s\"", "[string,ground]"),
      types("[1]", "[list,structure,ground]"),
      types("{!a; !b}", "[literal,structure,plan,ground]"),
      types("{a :- b}", "[literal,structure,rule,ground]"),
      types("true", "[atom,literal,ground]"),
      {".findall(K, .type(_, K), L); .print(L)", {"[free]"}},
      {".set.create(S); .findall(K, .type(S, K), L); .print(L)", {"[set,ground]"}},
      {".map.create(S); .findall(K, .type(S, K), L); .print(L)", {"[map,ground]"}},
      {".queue.create(S); .findall(K, .type(S, K), L); .print(L)", {"[queue,ground]"}},
      {".type(a, number)", {"failed: ia_failed"}},
  });
}

TEST(TypeActions, TestTypes) {
  const std::string holds = ".print(yes)";
  expect_lines({
      {".atom(a); .list([]); .literal(f(1)); .number(1); .string(\"s\"); .print(yes)", {"yes"}},
      {".structure([]); .structure(f(1)); .ground([a]); .print(yes)", {"yes"}},
      {".internal_action(.print(1)); .print(yes)", {"yes"}},
      {".atom(f(1))", {"failed: ia_failed"}},
      {".atom(~a)", {"failed: ia_failed"}},
      {".atom(\"a\")", {"failed: ia_failed"}},
      {".structure(a)", {"failed: ia_failed"}},
      {".literal([])", {"failed: ia_failed"}},
      {".literal(X)", {"failed: ia_failed"}},
      {".ground(f(X))", {"failed: ia_failed"}},
      {".ground(f[X])", {"failed: ia_failed"}},
      {".internal_action(print(1))", {"failed: ia_failed"}},
  });
}

TEST(AnnotationActions, AddAndRemove) {
  expect_lines({
      {".add_annot(p(1)[z], k(2), R); .print(R)", {"p(1)[k(2),z]"}},
      {".add_annot([a,b[x]], note, R); .print(R)", {"[a[note],b[note,x]]"}},
      {".add_annot(5, note, R); .print(R)", {"5"}},
      {".add_nested_source(f(x)[source(bob),k], ann, R); .print(R)",
       {"f(x)[k,source(ann)[source(bob)]]"}},
      {".remove_source_annot(q(1)[source(bob),keep], R); .print(R)", {"q(1)[keep]"}},
      {".remove_source_annot([q[source(a)],1], R); .print(R)", {"[q,1]"}},
      {".get_src_info(q, R); R = q[code_line(_)]; .print(yes)", {"failed: constraint_failed"}},
      {".get_src_info(q, R); q[code_line(_)] = R; .print(yes)", {"yes"}},
      {".get_src_info(1, R)", {"failed: ia_failed"}},
  });
}

TEST(CopyActions, GiveVariablesOfTheirOwn) {
  expect_lines({
      {".copy_term(p(X,X,1), C); C = p(a,Y,_); .print(Y, X)", {"aX<no-value>"}},
      {".rename_apart(p(X,X), C); C = p(a,Y); .print(Y, X)", {"aX<no-value>"}},
  });
}

}  // namespace
}  // namespace jaywalk::test
