// SPDX-License-Identifier: Apache-2.0
#pragma once

// Base of the readers of a scenario's sections: reads keys in a fixed order, and keeps where each
// was given. Read reader.h first.

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "env/config/reader.h"
#include "interpreter/support/source_files.h"

namespace jaywalk {

/// Where each key was given last, by its path.
using ValueOrigins = std::map<std::string, ValueOrigin>;

/// The files around a section while it is read. All references must outlive the reading.
struct SectionContext {
  /// The folder that paths are relative to; empty: the current folder.
  const std::string& folder;
  /// Reads the files that the section names.
  const SourceFiles& files;
  ValueOrigins& origins;
  Diagnostics& diagnostics;
};

/// Where a key was given, or else the key above it; the scenario itself if none was.
[[nodiscard]] ValueOrigin origin_of(const ValueOrigins& origins, std::string path,
                                    std::string_view scenario);

class SectionReader {
 protected:
  explicit SectionReader(const SectionContext& context)
      : context_(context), reader_(context.diagnostics) {}

  using KeyReader = std::function<void(const ConfigNode&, const std::string&)>;

  void note_origin(const ConfigNode& node, const std::string& path) {
    context_.origins[path] = node.origin;
  }

  // Keeps where the key was given, for errors that later checks find.
  void read_keys(const ConfigNode& node, const std::string& path,
                 std::initializer_list<ConfigKey> keys) {
    read_keys(node, path, std::span(keys.begin(), keys.size()));
  }
  void read_keys(const ConfigNode& node, const std::string& path, std::span<const ConfigKey> keys) {
    note_origin(node, path);
    reader_.read_map(node, path, keys);
  }

  // The handlers of plain values: read, check, store.
  KeyReader number(double& target, NumberRange range) {
    return [this, &target, range](const ConfigNode& node, const std::string& path) {
      note_origin(node, path);
      if (const auto value = reader_.number(node, range)) target = *value;
    };
  }
  template <class T>
  KeyReader integer(T& target, IntegerRange range) {
    return [this, &target, range](const ConfigNode& node, const std::string& path) {
      note_origin(node, path);
      if (const auto value = reader_.integer(node, range)) target = static_cast<T>(*value);
    };
  }
  KeyReader optional_number(std::optional<double>& target, NumberRange range) {
    return [this, &target, range](const ConfigNode& node, const std::string& path) {
      note_origin(node, path);
      if (const auto value = reader_.number(node, range)) target = *value;
    };
  }
  template <class T>
  KeyReader speed(T& target, NumberRange range, std::string_view mps_key) {
    return [this, &target, range, mps_key](const ConfigNode& node, const std::string& path) {
      note_origin(node, path);
      if (const auto value = reader_.speed(node, range, mps_key)) target = *value;
    };
  }
  KeyReader interval(Interval& target, IntegerRange range) {
    return [this, &target, range](const ConfigNode& node, const std::string& path) {
      note_origin(node, path);
      if (const auto value = reader_.interval(node, range)) target = *value;
    };
  }
  template <class T>
  KeyReader choice(T& target, std::initializer_list<Choice<T>> choices) {
    return [this, &target, words = std::vector<Choice<T>>(choices)](const ConfigNode& node,
                                                                    const std::string& path) {
      note_origin(node, path);
      if (const auto value = reader_.choice(node, std::span<const Choice<T>>(words))) {
        target = *value;
      }
    };
  }

  // Reads each item of a list; the new list replaces the items that `target` had.
  template <class Item>
  void read_list(const ConfigNode& node, const std::string& path, std::string_view expected,
                 std::vector<Item>& target, std::function<void(const ConfigNode&, Item&)> read) {
    note_origin(node, path);
    if (node.kind != ConfigNode::Kind::list || node.items.size() > kMaxItems) {
      reader_.unexpected(node, expected);
      return;
    }
    target.clear();
    for (const ConfigNode& item : node.items) read(item, target.emplace_back());
  }

  void require(const ConfigNode& node, std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys) {
      if (node.kind == ConfigNode::Kind::map && node.find(key) == nullptr) {
        reader_.error(node.origin, fmt::format("the key '{}' is missing", key));
      }
    }
  }

  // As many items as a list may have.
  static constexpr std::size_t kMaxItems = 1000;

  SectionContext context_;
  ConfigReader reader_;
};

/// A program and its arguments. Words that name a file beside the scenario become that file's path.
[[nodiscard]] std::optional<std::vector<std::string>> read_command_words(
    const ConfigNode& node, const SectionContext& context, const ConfigReader& reader);

}  // namespace jaywalk
