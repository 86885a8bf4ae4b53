#pragma once

// Some tests of a store as a store of its own.

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace jaywalk {

/// Copies the store `from` to a new file `to` with the tests of these ids only. The copy keeps the
/// description of the whole experiment; it is for programs that read its tables. Returns why that
/// was not possible.
[[nodiscard]] std::optional<std::string> copy_tests(const std::string& from, const std::string& to,
                                                    std::span<const std::int64_t> ids);

}  // namespace jaywalk
