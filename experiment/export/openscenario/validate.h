#pragma once

// Exported files against ASAM's schemas, which users have from asam.net.

#include <string>
#include <vector>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// Checks each `.xosc` and `.xodr` file by `xmllint`, which prints what is wrong, against the
/// schema of the version that its header says: one of the `.xsd` files in the folder or in folders
/// below it. Schemas say their version in their first lines or else in their names; if there is
/// none of the file's, the next later one serves, with a warning, since later versions take what
/// earlier ones take. Adds an error for each file that is not valid, and where schemas or xmllint
/// are missing.
void validate(const std::vector<std::string>& files, const std::string& folder,
              Diagnostics& diagnostics);

}  // namespace jaywalk
