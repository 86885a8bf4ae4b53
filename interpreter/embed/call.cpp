// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent/agent.h"
#include "interpreter/logic/action.h"
#include "interpreter/logic/solutions.h"

namespace jaywalk {

std::size_t Call::count() const { return call_->count(); }
Value Call::arg(std::size_t index) const { return call_->arg(index); }
Terms Call::terms() const { return {call_->heap(), call_->symbols()}; }
const std::string& Call::agent() const { return call_->agent()->name(); }
bool Call::unify(std::size_t index, Value value) { return call_->unify(index, value); }

Outcome Call::each(std::function<bool(Call& call)> next) {
  return jaywalk::each(*call_, [next = std::move(next)](ActionCall& internal) {
    Call call(internal);
    return next(call);
  });
}

void Call::solve(std::size_t index, const std::function<bool()>& solution) {
  call_->solve(index, solution);
}

Outcome Call::fail(std::string id, std::string message) {
  return call_->fail(std::move(id), std::move(message));
}
Outcome Call::wrong_argument(std::size_t index, std::string_view expected) {
  return call_->wrong_argument(index, expected);
}

std::optional<std::uint32_t> Call::intention() const {
  if (call_->intention() == nullptr) return std::nullopt;
  return call_->intention()->id;
}

Outcome Call::suspend(std::string reason) {
  if (call_->intention() == nullptr)
    return fail("internal_action", "a context or rule cannot wait");
  call_->agent()->suspend(*call_->intention(), Intention::State::waiting, std::move(reason));
  return Outcome::suspended;
}

}  // namespace jaywalk
