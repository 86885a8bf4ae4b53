// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <string_view>

#include "interpreter/actions/actions.h"
#include "interpreter/actions/functions.h"
#include "interpreter/actions/table/action_traits.h"

namespace jaywalk {
namespace actions {

std::vector<Value> elements(Value list) {
  list = deref(list);
  std::size_t count = 0;
  for (Value rest = list; rest.is_pair(); rest = deref(rest.pair()->tail)) ++count;
  std::vector<Value> found;
  found.reserve(count);  // of a list that takes much memory no more than needed
  for (; list.is_pair(); list = deref(list.pair()->tail)) {
    found.push_back(deref(list.pair()->head));
  }
  return found;
}

}  // namespace actions

namespace {

std::string name_in(std::string_view signature) {
  return std::string(signature.substr(0, signature.find('(')));
}

ActionRegistry make_standard_actions() {
  ActionRegistry registry;
  using namespace action_words;
#define JAYWALK_ACTION(function, least, most, kind, traits, signature, summary)                  \
  registry.add(ActionDefinition{name_in(signature), least, most, &actions::function, signature,  \
                                summary, (kind).body_only, (kind).formula_args, (kind).raw_args, \
                                (kind).is_uncounted});
#include "interpreter/actions/table/actions.def"
#undef JAYWALK_ACTION
#define JAYWALK_FUNCTION(function, least, most, signature, summary)                      \
  registry.add(FunctionDefinition{name_in(signature), least, most, &functions::function, \
                                  signature, summary});
#define JAYWALK_MACHINE_FUNCTION(least, most, signature, summary) \
  registry.add(FunctionDefinition{name_in(signature), least, most, nullptr, signature, summary});
#include "interpreter/actions/functions.def"
  return registry;
}

}  // namespace

const ActionRegistry& standard_actions() {
  static const ActionRegistry registry = make_standard_actions();
  return registry;
}

}  // namespace jaywalk
