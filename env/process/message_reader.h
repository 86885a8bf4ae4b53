// SPDX-License-Identifier: Apache-2.0
#pragma once

// The fields of messages from other programs, which may be anything.

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace jaywalk {

/// Reads the fields of a message from another program, which may be anything. Keeps the first error
/// as a message for people; wrong fields read as 0, empty or null. `of` names the message, or the
/// part of it that has the field, in the error.
class MessageReader {
 public:
  using Json = nlohmann::json;

  double number(const Json& object, const char* key, std::string_view of);
  double number_or(const Json& object, const char* key, std::string_view of, double otherwise);
  std::string text(const Json& object, const char* key, std::string_view of);
  bool flag_or(const Json& object, const char* key, std::string_view of, bool otherwise);
  const Json* object(const Json& object, const char* key, std::string_view of);
  /// Null where there is none, which is wrong if it is needed.
  const Json* list(const Json& object, const char* key, std::string_view of, bool needed);

  void reject(std::string why);
  /// Empty if nothing was wrong.
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  const Json* field(const Json& object, const char* key, std::string_view of);
  void reject_kind(const char* key, std::string_view of, std::string_view expected);

  std::string problem_;
};

}  // namespace jaywalk
