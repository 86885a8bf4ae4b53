// SPDX-License-Identifier: Apache-2.0
#include "env/lane/controller.h"

#include <algorithm>
#include <array>

#include "env/lane/controllers/controllers.h"

namespace jaywalk::lane {

std::span<const ControllerKind> controllers() {
  static const std::array kinds = {
#define JAYWALK_CONTROLLER(identifier, name, summary) \
  ControllerKind{name, summary, controller::identifier::parameters(), controller::identifier::make},
#include "env/lane/controllers.def"
#undef JAYWALK_CONTROLLER
  };
  return kinds;
}

const ControllerKind* find_controller(std::string_view name) {
  const auto found = std::ranges::find(controllers(), name, &ControllerKind::name);
  return found == controllers().end() ? nullptr : &*found;
}

}  // namespace jaywalk::lane
