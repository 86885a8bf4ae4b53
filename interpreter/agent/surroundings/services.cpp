// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent/surroundings/services.h"

#include <algorithm>

namespace jaywalk {

bool ServiceDirectory::matches(const Service& offered, const Service& wanted) {
  return offered.name == wanted.name &&
         (offered.type == wanted.type || offered.type.empty() || wanted.type.empty());
}

std::string ServiceDirectory::key(std::string_view agent, const Service& service) {
  std::string text(agent);
  return text.append(1, '\n').append(service.name).append(1, '\n').append(service.type);
}

void ServiceDirectory::add(const std::string& agent, const Service& service) {
  if (!known_.insert(key(agent, service)).second) return;
  offers_.push_back({agent, service});
  for (const Entry& subscription : subscriptions_) {
    if (matches(service, subscription.service)) tell_(subscription.agent, agent, service.name);
  }
}

void ServiceDirectory::remove(std::string_view agent, const Service& service) {
  std::erase_if(offers_, [&](const Entry& entry) {
    if (entry.agent != agent || !matches(entry.service, service)) return false;
    known_.erase(key(agent, entry.service));
    return true;
  });
}

std::vector<std::string> ServiceDirectory::search(const Service& service) const {
  std::vector<std::string> found;
  for (const Entry& entry : offers_) {
    if (matches(entry.service, service) &&
        std::find(found.begin(), found.end(), entry.agent) == found.end()) {
      found.push_back(entry.agent);
    }
  }
  return found;
}

void ServiceDirectory::subscribe(const std::string& agent, const Service& service) {
  subscriptions_.push_back({agent, service});
  for (const std::string& provider : search(service)) tell_(agent, provider, service.name);
}

void ServiceDirectory::forget(std::string_view agent) {
  const auto is_its = [&](const Entry& entry) { return entry.agent == agent; };
  std::erase_if(offers_, [&](const Entry& entry) {
    if (!is_its(entry)) return false;
    known_.erase(key(agent, entry.service));
    return true;
  });
  std::erase_if(subscriptions_, is_its);
}

}  // namespace jaywalk
