// SPDX-License-Identifier: Apache-2.0
#pragma once

// Declares the function that each controller's file defines, from the table.

#include "env/lane/controller.h"

namespace jaywalk::lane::controller {
#define JAYWALK_CONTROLLER(identifier, name, summary)             \
  namespace identifier {                                          \
  std::span<const NumberParameter> parameters();                  \
  std::unique_ptr<Controller> make(const ControllerSetup& setup); \
  }
#include "env/lane/controllers.def"
#undef JAYWALK_CONTROLLER
}  // namespace jaywalk::lane::controller
