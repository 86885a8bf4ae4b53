// SPDX-License-Identifier: Apache-2.0
// The native half of the Python package `jaywalk`; python/jaywalk/ is the half that users see.

#include "python/module/values.h"

PYBIND11_MODULE(_native, module) {
  module.doc() = "The native half of the package jaywalk; use the package.";
  jaywalk::python::add_agents(module);
  jaywalk::python::add_bench(module);
  jaywalk::python::add_search(module);
}
