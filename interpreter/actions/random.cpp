#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"

namespace jaywalk::actions {
namespace {

// N draws, or draws without end.
class Draws : public Solutions {
 public:
  Draws(std::size_t argument, std::vector<Value> elements, double count)
      : argument_(argument), elements_(std::move(elements)), left_(count), endless_(count == 0) {}

  bool next(ActionCall& call) override {
    if (!endless_ && left_ < 1) return false;
    --left_;
    JavaRandom& random = call.agent()->random();
    const Value drawn =
        elements_.empty()
            ? Value::number(random.next_double())
            : elements_[static_cast<std::size_t>(
                  random.next_int(static_cast<std::int32_t>(elements_.size())))];
    return call.unify(argument_, drawn);
  }

 private:
  std::size_t argument_;
  std::vector<Value> elements_;
  double left_;
  bool endless_;
};

}  // namespace

Outcome random(ActionCall& call) {
  if (call.agent() == nullptr) return Outcome::failed;
  std::vector<Value> from;
  const std::size_t result = call.arg(0).is_list() ? 1 : 0;
  if (result == 1) {
    from = elements(call.arg(0));
    if (from.empty() || call.count() < 2) return Outcome::failed;
  }
  double count = 1;
  if (call.count() > result + 1) {
    if (!call.arg(result + 1).is_number()) return call.wrong_argument(result + 1, "a number");
    count = call.arg(result + 1).as_number();
  }
  return call.many(std::make_unique<Draws>(result, std::move(from), count));
}

Outcome set_random_seed(ActionCall& call) {
  if (!call.arg(0).is_number()) return call.wrong_argument(0, "a number");
  call.agent()->random().set_seed(static_cast<std::int64_t>(call.arg(0).as_number()));
  return Outcome::succeeded;
}

}  // namespace jaywalk::actions
