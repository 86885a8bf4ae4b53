#include "tools/jaywalk/lsp/lsp_frames.h"

#include <algorithm>
#include <charconv>

namespace jaywalk::lsp {
namespace {

constexpr std::size_t kLongestLine = 1000;

/// Reads a line of a header, without its line break; false at the end of the stream.
bool read_line(std::istream& in, std::string& line) {
  line.clear();
  for (int c = in.get(); c != std::istream::traits_type::eof(); c = in.get()) {
    if (c == '\n') {
      if (line.ends_with('\r')) line.pop_back();
      return true;
    }
    if (line.size() < kLongestLine) line += static_cast<char>(c);
  }
  return !line.empty();
}

std::optional<std::size_t> length_in(std::string_view line) {
  constexpr std::string_view kName = "content-length:";
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  if (line.size() < kName.size() || !std::equal(kName.begin(), kName.end(), line.begin(),
                                                [&](char a, char b) { return a == lower(b); })) {
    return std::nullopt;
  }
  line.remove_prefix(std::min(line.find_first_not_of(" \t", kName.size()), line.size()));
  std::size_t length = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), length);
  if (error != std::errc() || end != line.data() + line.size()) return std::nullopt;
  return length;
}

}  // namespace

std::optional<Frame> read_frame(std::istream& in) {
  std::string line;
  std::optional<std::size_t> length;
  bool any = false;
  while (read_line(in, line)) {
    if (line.empty()) {
      if (any) break;
      continue;
    }
    any = true;
    if (const auto found = length_in(line)) length = found;
  }
  if (!any) return std::nullopt;
  Frame frame;
  frame.is_broken = !length || *length > kLongestMessage;
  if (frame.is_broken) return frame;
  frame.content.resize(*length);
  in.read(frame.content.data(), static_cast<std::streamsize>(*length));
  frame.is_broken = static_cast<std::size_t>(in.gcount()) != *length;
  if (frame.is_broken) frame.content.clear();
  return frame;
}

void write_frame(std::ostream& out, std::string_view content) {
  out << "Content-Length: " << content.size() << "\r\n\r\n" << content << std::flush;
}

}  // namespace jaywalk::lsp
