// SPDX-License-Identifier: Apache-2.0
#include "interpreter/actions/table/action_traits.h"

#include <set>
#include <string_view>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

constexpr std::size_t kNone = ActionTraits::kNever;

TEST(ActionTraits, AreThoseOfTheNamedRow) {
  EXPECT_FALSE(traits_of(".print").binds);
  EXPECT_TRUE(traits_of(".my_name").binds);
  EXPECT_TRUE(traits_of(".fail").fails);
  EXPECT_TRUE(traits_of(".remove_plan").removes_plans);
  EXPECT_EQ(traits_of(".suspended").about, About::goal);
  EXPECT_TRUE(traits_of(".assertz").is_about_belief());
}

TEST(ActionTraits, OfWhatIsNoActionAllowEverything) {
  for (const char* name : {".no_such_action", "print", "send", ""}) {
    EXPECT_EQ(find_action_row(name), nullptr) << name;
    EXPECT_TRUE(traits_of(name).binds) << name;
    EXPECT_FALSE(traits_of(name).is_social()) << name;
    EXPECT_FALSE(traits_of(name).is_far(9)) << name;
  }
}

TEST(ActionTraits, FindTheArgumentThatIsAQuery) {
  EXPECT_EQ(query_index(".findall", 3), 1U);
  EXPECT_EQ(query_index(".count", 1), 0U);
  EXPECT_EQ(query_index(".count", 2), 0U);
  EXPECT_EQ(query_index(".eval", 2), 1U);
  EXPECT_EQ(query_index(".max", 3), 1U);
  EXPECT_EQ(query_index(".max", 2), kNone);
  EXPECT_EQ(query_index(".count", 0), kNone);
  EXPECT_EQ(query_index(".print", 2), kNone);
}

TEST(ActionTraits, SayWithHowManyArgumentsAnActionWaitsOrIsFar) {
  EXPECT_TRUE(traits_of(".suspend").waits_with(0));
  EXPECT_FALSE(traits_of(".suspend").waits_with(1));
  EXPECT_TRUE(traits_of(".send").waits_with(4));
  EXPECT_FALSE(traits_of(".send").waits_with(3));
  EXPECT_TRUE(traits_of(".stopMAS").is_far(1));
  EXPECT_FALSE(traits_of(".stopMAS").is_far(0));
  EXPECT_TRUE(traits_of(".df_search").is_far(2));
  EXPECT_FALSE(traits_of(".send").is_far(5)) << "messages come with the next round";
}

TEST(ActionTraits, KnowWhereAMessageBegins) {
  EXPECT_EQ(traits_of(".send").performative, 1U);
  EXPECT_EQ(traits_of(".broadcast").performative, 0U);
  for (const char* name : {".send", ".broadcast", ".my_name", ".create_agent", ".df_subscribe"}) {
    EXPECT_TRUE(traits_of(name).is_social()) << name;
  }
}

TEST(ActionTraits, AreThoseOfOneRowForEachName) {
  std::set<std::string_view> names;
  for (const ActionRow& row : kActionRows) EXPECT_TRUE(names.insert(row.name).second) << row.name;
  EXPECT_GT(names.size(), 100U);
}

}  // namespace
}  // namespace jaywalk
