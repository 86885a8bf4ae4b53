// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/run/trace_output.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "experiment/scenario/files/write_file.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

TraceFile::TraceFile(std::string path) : path_(std::move(path)) {
  const std::string replaced = replaced_file(path_);
  if (!replaced.empty()) path_ = replaced;
  if (!replaced.empty()) part_.emplace(path_);
  if (!part_) {
    file_ = std::fopen(path_.c_str(), "wb");
  } else if (part_->is_open()) {
    file_ = std::fopen(part_->name().c_str(), "wb");
  }
  if (file_ == nullptr) failure_ = std::generic_category().message(errno);
}

TraceFile::~TraceFile() {
  if (file_ != nullptr) std::fclose(file_);
}

void TraceFile::write(std::string_view lines) {
  if (!failure_.empty() || file_ == nullptr || lines.empty()) return;
  if (std::fwrite(lines.data(), 1, lines.size(), file_) != lines.size()) {
    failure_ = std::generic_category().message(errno);
  }
}

void TraceFile::add(std::uint64_t number, std::string lines) {
  const std::lock_guard lock(mutex_);
  waiting_.emplace(number, std::move(lines));
  for (auto it = waiting_.begin(); it != waiting_.end() && it->first == next_; ++next_) {
    write(it->second);
    it = waiting_.erase(it);
  }
}

std::string TraceFile::finish() {
  // After an interruption there are gaps.
  for (const auto& [number, lines] : waiting_) write(lines);
  waiting_.clear();
  if (file_ != nullptr && std::fclose(file_) != 0 && failure_.empty()) {
    failure_ = std::generic_category().message(errno);
  }
  file_ = nullptr;
  if (failure_.empty() && part_ && !part_->replace()) {
    failure_ = std::generic_category().message(errno);
  }
  return failure_;
}

bool open_trace(const Arguments& arguments, std::optional<TraceFile>& trace, Console& console) {
  const auto path = arguments.text(option::kTrace);
  if (!path) return true;
  trace.emplace(*path);
  if (trace->failure().empty()) return true;
  console.error(fmt::format("cannot write '{}': {}", *path, trace->failure()));
  return false;
}

bool finish_trace(const Arguments& arguments, std::optional<TraceFile>& trace, Console& console) {
  if (!trace) return true;
  const std::string why = trace->finish();
  const std::string path = arguments.text(option::kTrace).value_or("");
  if (why.empty()) {
    console.wrote(path);
    return true;
  }
  console.error(fmt::format("cannot write '{}': {}", path, why));
  return false;
}

}  // namespace jaywalk
