#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

#include "common/transport/survey/domain_survey.h"

namespace accord {
namespace {

using Role = AccordName::Role;

constexpr std::string_view kBus = "accord";
constexpr std::string_view kFleet = "accord-fleet";

std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> out;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t slash = std::min(text.find('/', from), text.size());
    out.push_back(text.substr(from, slash - from));
    from = slash + 1;
  }
  return out;
}

template <typename Number>
bool parse(std::string_view text, int base, Number& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out, base);
  return error == std::errc() && end == text.data() + text.size();
}

Role role_in(std::string_view word) {
  if (word == "coordinator") return Role::kCoordinator;
  if (word == "worker") return Role::kWorker;
  if (word == "service") return Role::kService;
  if (word == "client") return Role::kClient;
  if (word == "doctor") return Role::kDoctor;
  return Role::kOther;
}

bool is_on_the_bus(Role role) {
  return role == Role::kCoordinator || role == Role::kWorker;
}

}  // namespace

// Others' protocols are read by the same rule as ours, for as long as they keep to it: who does not
// is a stranger.
std::optional<AccordName> accord_name_in(const std::string& user_data) {
  const auto parts = parts_of(user_data);
  if (parts.size() < 4) return std::nullopt;
  AccordName name{role_in(parts[3]), std::string(parts[1])};
  if (!is_cluster_name(name.cluster) || !parse(parts[2], 10, name.protocol)) return std::nullopt;
  if (parts[0] == kFleet) {
    return is_on_the_bus(name.role) ? std::nullopt : std::optional(name);
  }
  if (parts[0] != kBus || !is_on_the_bus(name.role)) return std::nullopt;
  if (parts.size() < 5 || !parse(parts[4], 16, name.id)) return std::nullopt;
  return name;
}

}  // namespace accord
