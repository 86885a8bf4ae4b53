// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "interpreter/support/diagnostics.h"
#include "interpreter/support/input/missing_file.h"
#include "interpreter/support/input/read_pipe.h"
#include "interpreter/support/remarks.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

constexpr std::size_t kBlock = std::size_t{64} << 10U;
constexpr std::string_view kEncoding = "encoding";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

Diagnostics failure(const std::string& path, std::string message, std::string hint = {}) {
  Diagnostics diagnostics;
  diagnostics.error(path, std::move(message), std::move(hint));
  return diagnostics;
}

// How many bytes the character at `at` has, or 0 if it is not one (RFC 3629: no overlong forms, no
// surrogates, nothing above U+10FFFF).
std::size_t character_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
  };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned lead = byte(0);
  if (lead < 0x80U) return 1;
  if (lead >= 0xC2U && lead <= 0xDFU) return continues(1) ? 2 : 0;
  if (lead >= 0xE0U && lead <= 0xEFU) {
    const bool overlong = lead == 0xE0U && byte(1) < 0xA0U;
    const bool surrogate = lead == 0xEDU && byte(1) > 0x9FU;
    return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (lead >= 0xF0U && lead <= 0xF4U) {
    const bool overlong = lead == 0xF0U && byte(1) < 0x90U;
    const bool too_large = lead == 0xF4U && byte(1) > 0x8FU;
    return continues(1) && continues(2) && continues(3) && !overlong && !too_large ? 4 : 0;
  }
  return 0;
}

// Whether the eight bytes from there on are all ASCII.
bool is_ascii_word(std::string_view text, std::size_t at) {
  constexpr std::uint64_t kHighBits = 0x8080'8080'8080'8080U;
  std::uint64_t word = kHighBits;
  if (text.size() - at >= sizeof(word)) std::memcpy(&word, text.data() + at, sizeof(word));
  return (word & kHighBits) == 0;
}

// The text with U+FFFD for each byte that is not part of a character.
std::string with_replacements(std::string_view text) {
  constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
  std::string replaced;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    replaced += length == 0 ? kReplacement : text.substr(at, length);
    at += std::max<std::size_t>(length, 1);
  }
  return replaced;
}

// Reads at most one byte more than `max_bytes`; works for devices, too, whose size is unknown.
Result<std::string> read_file(const std::string& path, std::size_t max_bytes) {
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return failure(path, fmt::format("cannot be read: {}", std::strerror(errno)));
  std::string text;
  std::string block(kBlock, '\0');
  while (text.size() <= max_bytes && stream) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block, 0, static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return failure(path, "cannot be read to its end");
  return text;
}

Result<std::string> read_bytes(const std::string& path, std::size_t max_bytes) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    return failure(path, "no such file", hint_for_missing(path));
  if (std::filesystem::is_directory(status)) {
    return failure(path, "this is a folder, a file was expected");
  }
  const bool is_pipe = std::filesystem::is_fifo(status);
  Result<std::string> text = is_pipe ? read_pipe(path, max_bytes) : read_file(path, max_bytes);
  if (text && text.value().size() > max_bytes) {
    return failure(path, fmt::format("larger than {} bytes", max_bytes));
  }
  return text;
}

// Describes an invalid byte and its line.
std::string encoding_problem(std::string_view text, std::size_t bad) {
  const auto value = static_cast<unsigned>(static_cast<unsigned char>(text[bad]));
  return fmt::format(
      "not UTF-8 text: unexpected byte 0x{:02X} at offset {} (line {})", value, bad,
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bad), '\n'));
}

constexpr std::string_view kSaveAsUtf8 = "save the file in the encoding UTF-8";

SourcePtr as_source(const std::string& path, std::string text) {
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  return std::make_shared<const Source>(path, std::move(text));
}

}  // namespace

std::optional<std::size_t> first_bad_byte(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    if (is_ascii_word(text, at)) {
      at += sizeof(std::uint64_t);
      continue;
    }
    const std::size_t length = character_length(text, at);
    if (length == 0) return at;
    at += length;
  }
  return std::nullopt;
}

Result<SourcePtr> read_source(const std::string& path, std::size_t max_bytes) {
  Result<std::string> text = read_bytes(path, max_bytes);
  if (!text) return std::move(text.diagnostics());
  if (const std::optional<std::size_t> bad = first_bad_byte(text.value())) {
    return failure(path, encoding_problem(text.value(), *bad), std::string(kSaveAsUtf8));
  }
  return as_source(path, std::move(text).value());
}

Result<SourcePtr> read_any_encoding(const std::string& path, Diagnostics& diagnostics) {
  Result<std::string> text = read_bytes(path, std::size_t{64} << 20U);
  if (!text) return std::move(text.diagnostics());
  const std::optional<std::size_t> bad = first_bad_byte(text.value());
  if (!bad) return as_source(path, std::move(text).value());
  SourcePtr source = as_source(path, with_replacements(text.value()));
  if (is_silenced(*source, 0, kEncoding)) return source;
  diagnostics.add({.severity = Severity::warning,
                   .message = encoding_problem(text.value(), *bad),
                   .where = {},
                   .hint = std::string(kSaveAsUtf8),
                   .code = std::string(kEncoding),
                   .subject = path});
  return source;
}

}  // namespace jaywalk
