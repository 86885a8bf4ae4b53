// SPDX-License-Identifier: Apache-2.0
// Comments for the checker that it cannot follow.

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "interpreter/check/checking.h"
#include "interpreter/support/remarks.h"

namespace jaywalk {
namespace {

void look_at_code(Checking& checking, CheckedFile& file, const Remark& remark,
                  const std::vector<std::string>& codes) {
  if (std::ranges::find(codes, remark.item) != codes.end()) return;
  std::string hint = did_you_mean(remark.item, codes);
  if (hint.empty()) hint = "`jaywalk check --list` names them";
  checking.warn(file, remark.item_span, fmt::format("there is no warning '{}'", remark.item),
                std::move(hint));
}

}  // namespace

void unknown_codes(Checking& checking) {
  std::vector<std::string> codes;
  for (const CheckInfo& check : checks()) codes.emplace_back(check.name);
  const std::vector<std::string> words = {
      std::string(Remark::kAllow), std::string(Remark::kAllowFile), std::string(Remark::kAsks)};
  for (CheckedFile& file : checking.files()) {
    for (const Remark& remark : remarks(*file.file->source)) {
      if (remark.allows()) {
        look_at_code(checking, file, remark, codes);
      } else if (remark.word != Remark::kAsks) {
        // Any other word may be prose.
        std::string hint = did_you_mean(remark.word, words);
        if (hint.empty()) continue;
        checking.warn(file, remark.word_span,
                      fmt::format("'{}' means nothing in a comment for the checker", remark.word),
                      std::move(hint));
      } else if (!asked_name(remark.item)) {
        checking.warn(
            file, remark.item_span,
            fmt::format("expected a name with its number of arguments, found '{}'", remark.item),
            "as in `asks radius/1`, or `asks !cross/0` for a goal");
      }
    }
  }
}

}  // namespace jaywalk
