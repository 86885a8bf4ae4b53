#pragma once

// Exported files against ASAM's schemas, which users have from asam.net.

#include <string>
#include <vector>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// Checks `.xosc` files against an OpenSCENARIO schema and `.xodr` files against an OpenDRIVE one,
/// both `.xsd` files in the folder, by `xmllint`, which prints what is wrong. Adds an error for
/// each file that is not valid, and where a schema or xmllint is missing.
void validate(const std::vector<std::string>& files, const std::string& folder,
              Diagnostics& diagnostics);

}  // namespace jaywalk
