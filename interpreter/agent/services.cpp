#include "interpreter/agent/services.h"

#include <algorithm>

namespace jaywalk {

bool ServiceDirectory::matches(const Service& offered, const Service& wanted) {
  return offered.name == wanted.name &&
         (offered.type == wanted.type || offered.type.empty() || wanted.type.empty());
}

void ServiceDirectory::add(const std::string& agent, const Service& service) {
  const bool known = std::any_of(offers_.begin(), offers_.end(), [&](const Entry& entry) {
    return entry.agent == agent && entry.service.name == service.name &&
           entry.service.type == service.type;
  });
  if (known) return;
  offers_.push_back({agent, service});
  for (const Entry& subscription : subscriptions_) {
    if (matches(service, subscription.service)) tell_(subscription.agent, agent, service.name);
  }
}

void ServiceDirectory::remove(std::string_view agent, const Service& service) {
  std::erase_if(offers_, [&](const Entry& entry) {
    return entry.agent == agent && matches(entry.service, service);
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
  std::erase_if(offers_, is_its);
  std::erase_if(subscriptions_, is_its);
}

}  // namespace jaywalk
