// SPDX-License-Identifier: Apache-2.0
#include "env/process/message_reader.h"

#include <utility>

#include <fmt/format.h>

namespace jaywalk {
namespace {

const MessageReader::Json* find_in(const MessageReader::Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

}  // namespace

double MessageReader::number(const Json& object, const char* key, std::string_view of) {
  const Json* const found = field(object, key, of);
  if (found == nullptr) return 0;
  if (!found->is_number()) return reject_kind(key, of, "a number"), 0;
  return found->get<double>();
}

double MessageReader::number_or(const Json& object, const char* key, std::string_view of,
                                double otherwise) {
  return find_in(object, key) != nullptr ? number(object, key, of) : otherwise;
}

std::string MessageReader::text(const Json& object, const char* key, std::string_view of) {
  const Json* const found = field(object, key, of);
  if (found == nullptr) return {};
  if (!found->is_string()) return reject_kind(key, of, "a text"), std::string();
  return found->get<std::string>();
}

bool MessageReader::flag_or(const Json& object, const char* key, std::string_view of,
                            bool otherwise) {
  const Json* const found = find_in(object, key);
  if (found == nullptr) return otherwise;
  if (!found->is_boolean()) return reject_kind(key, of, "true or false"), otherwise;
  return found->get<bool>();
}

const MessageReader::Json* MessageReader::object(const Json& object, const char* key,
                                                 std::string_view of) {
  const Json* const found = field(object, key, of);
  if (found == nullptr) return nullptr;
  if (!found->is_object()) return reject_kind(key, of, "an object"), nullptr;
  return found;
}

const MessageReader::Json* MessageReader::list(const Json& object, const char* key,
                                               std::string_view of, bool needed) {
  const Json* const found = needed ? field(object, key, of) : find_in(object, key);
  if (found == nullptr) return nullptr;
  if (!found->is_array()) return reject_kind(key, of, "a list"), nullptr;
  return found;
}

void MessageReader::reject(std::string why) {
  if (problem_.empty()) problem_ = std::move(why);
}

const MessageReader::Json* MessageReader::field(const Json& object, const char* key,
                                                std::string_view of) {
  const Json* const found = find_in(object, key);
  if (found == nullptr) reject(fmt::format("there is no '{}' in {}", key, of));
  return found;
}

void MessageReader::reject_kind(const char* key, std::string_view of, std::string_view expected) {
  reject(fmt::format("'{}' in {} is not {}", key, of, expected));
}

}  // namespace jaywalk
