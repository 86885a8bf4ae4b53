// SPDX-License-Identifier: Apache-2.0
// .concat .delete .substring .replace .lower_case .upper_case .term2string

#include <gtest/gtest.h>

#include "tests/unit/actions/bodies.h"

namespace jaywalk::test {
namespace {

TEST(StringActions, JoinTextsAndLists) {
  expect_lines({
      {".concat(\"n=\", 5, ' t ', f(x), [1], R); .print(R)", {"n=5 t f(x)[1]"}},
      {".concat(a, b, R); .string(R); .print(R)", {"ab"}},
      {".concat(a, b, \"ab\"); .concat(a, b, ab); .print(yes)", {"yes"}},
      {".concat(a, b, \"ac\")", {"failed: ia_failed"}},
      {".concat([1], [], [2,3], R); .print(R)", {"[1,2,3]"}},
      {".concat([1], T, R); T = [2]; .print(R)", {"failed: wrong_arguments"}},
      {".concat([1], a, R)", {"failed: wrong_arguments"}},
      {".concat(a); .concat([a]); .print(yes)", {"yes"}},
  });
}

TEST(StringActions, DeleteElementsRangesAndMatches) {
  expect_lines({
      {".delete(a, [a,b,a,c], R); .print(R)", {"[b,c]"}},
      {".delete(z, [a], R); .print(R)", {"[a]"}},
      // As in Jason, the first that unifies decides what goes; nothing is bound outside.
      {".delete(f(X), [f(1),g(2),f(3),f(1)], R); .print(R, X)", {"[g(2),f(3)]X<no-value>"}},
      {".delete(0, [p,q,r], A); .delete(5, [p], B); .print(A, B)", {"[q,r][p]"}},
      {".delete(1, 3, [k,l,m,n], R); .print(R)", {"[k,n]"}},
      {".delete(1, \"house\", A); .delete(1, 3, \"house\", B); .print(A, B)", {"husehse"}},
      {".delete(9, \"abc\", R); .print(R)", {"abc"}},
      {".delete(2147483647, [p,q], A); .delete(2147483647, \"pq\", B); .print(A, B)", {"[p,q]pq"}},
      {".delete(\"an\", \"banana\", A); .delete(\"[ab]\", \"cab\", B); .print(A, B)", {"bac"}},
      {".delete(\"[\", \"abc\", R)", {"failed: unknown"}},
      {".delete(a, b, R)", {"failed: internal_action"}},
  });
}

TEST(StringActions, FindSubstrings) {
  expect_lines({
      {".substring(\"ell\", \"hello\"); .print(yes)", {"yes"}},
      {".substring(\"x\", \"hello\")", {"failed: ia_failed"}},
      {".findall(P, .substring(\"a\", banana, P), L); .print(L)", {"[1,3,5]"}},
      {".findall(p(B,E), .substring(\"na\", \"banana\", B, E), L); .print(L)", {"[p(2,3),p(4,5)]"}},
      {".substring(a(10), b(t,a(10)), P); .print(P)", {"4"}},
      {".substring(\"a\", \"bab\", 1); .print(yes)", {"yes"}},
      {".substring(\"a\", \"bab\", 0)", {"failed: ia_failed"}},
      {".findall(P, .substring(\"\", \"ab\", P), L); .print(L)", {"[0,1]"}},
      {".substring(\"b\", \"\u00e4\U0001F600b\", P); .print(P)", {"3"}},
  });
}

TEST(StringActions, ExtractSubstrings) {
  expect_lines({
      {".substring(R, \"weekday\", 4); .print(R)", {"day"}},
      {".substring(R, \"weekday\", 0, 4); .print(R)", {"week"}},
      {".substring(\"weekday\", R, 4); .print(R)", {"day"}},
      {".substring(R, f(abc,12), 2); .print(R)", {"abc,12)"}},
      {".substring(R, \"abc\", 3); .length(R, N); .print(N)", {"0"}},
      {".substring(R, \"abc\", 4)", {"failed: unknown"}},
      {".substring(R, \"abc\", 2, 1)", {"failed: unknown"}},
      {".substring(R, \"abc\", -1)", {"failed: unknown"}},
  });
}

TEST(StringActions, ReplaceByRegularExpressions) {
  expect_lines({
      {".replace(\"a1b22\", \"[0-9]+\", \"#\", R); .print(R)", {"a#b#"}},
      {".replace(\"John Smith\", \"([a-zA-Z]+) ([a-zA-Z]+)\", \"$2, $1\", R); .print(R)",
       {"Smith, John"}},
      {".replace(f(a,b), \"[ab]\", \"x\", R); .print(R)", {"f(x,x)"}},
      {".replace(\"abc\", \"(\", \"\", R)", {"failed: unknown"}},
      {".replace(\"abc\", \"b\", \"$1\", R)", {"failed: unknown"}},
      {".replace(\"abc\", \"b\", \"b\", \"abc\"); .print(yes)", {"yes"}},
  });
}

TEST(StringActions, ChangeCase) {
  expect_lines({
      {".upper_case(\"Mixed 1\", A); .lower_case(\"Mixed 1\", B); .print(A, B)",
       {"MIXED 1mixed 1"}},
      {".upper_case(word, A); .string(A); .print(A)", {"WORD"}},
      {".upper_case(\"stra\u00dfe \u00e9\u044f\", A); .print(A)", {"STRASSE \u00c9\u042f"}},
      {".lower_case(\"\u00c9\u03a9\u0416\u0141\", A); .print(A)", {"\u00e9\u03c9\u0436\u0142"}},
  });
}

TEST(StringActions, TurnTermsIntoTextsAndBack) {
  expect_lines({
      {".term2string(f(1,\"q\",X), S); .length(S, N); .print(S, N)", {"f(1,\"q\",X)10"}},
      {".term2string(T, \"p(1,[a,b])\"); T = p(_,L); .print(L)", {"[a,b]"}},
      {".term2string(T, \"10\"); .print(T + 1)", {"11"}},
      {".term2string(T, \"2 * (3 + 4)\"); .print(T)", {"14"}},
      {".term2string(T, \"not a term\"); .atom(T); .print(T)", {"not a term"}},
      {".term2string(T, \"{+!g(1)}\"); .print(T)", {"{ +!g(1) }"}},
      {"N = 5; .term2string(T, \"f(N,M)\"); .print(T)", {"f(5,M)"}},
      {".term2string(b, \"b\"); .print(yes)", {"yes"}},
      {".term2string(b, \"c\")", {"failed: ia_failed"}},
      {".term2string(\"text\", S); .print(S)", {"\"text\""}},
      {".term2string(T, f(a)); .print(T)", {"f(a)"}},
      {".term2string(a, b)", {"failed: internal_action"}},
  });
}

}  // namespace
}  // namespace jaywalk::test
