// SPDX-License-Identifier: Apache-2.0
#pragma once

// The yellow pages, Jason's directory facilitator: which agent offers which service, and which
// agents want to be informed (`.df_register` and related actions).

#include <functional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace jaywalk {

struct Service {
  std::string name;
  /// Empty: of any type.
  std::string type;
};

class ServiceDirectory {
 public:
  /// Tells a subscriber of a provider.
  using Tell = std::function<void(const std::string& subscriber, const std::string& provider,
                                  const std::string& service)>;

  explicit ServiceDirectory(Tell tell) : tell_(std::move(tell)) {}

  void add(const std::string& agent, const Service& service);
  void remove(std::string_view agent, const Service& service);
  /// The providers, in the order in which they registered.
  [[nodiscard]] std::vector<std::string> search(const Service& service) const;
  /// The agent is informed about the providers of the service, present and future.
  void subscribe(const std::string& agent, const Service& service);
  /// The agent has left.
  void forget(std::string_view agent);

 private:
  struct Entry {
    std::string agent;
    Service service;
  };
  static bool matches(const Service& offered, const Service& wanted);
  static std::string key(std::string_view agent, const Service& service);

  Tell tell_;
  std::vector<Entry> offers_;
  std::unordered_set<std::string> known_;  // the keys of the offers
  std::vector<Entry> subscriptions_;
};

}  // namespace jaywalk
