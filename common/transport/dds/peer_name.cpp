#include "common/transport/dds/peer_name.h"

#include <array>
#include <charconv>

namespace accord::dds {
namespace {

constexpr std::string_view kProgram = "accord";
constexpr std::array<std::string_view, 2> kRoles = {"coordinator", "worker"};

// What comes before the next slash, or all; taken off the text.
std::string_view next_part(std::string_view& text) {
  const std::size_t slash = text.find('/');
  const std::string_view part = text.substr(0, slash);
  text.remove_prefix(slash == std::string_view::npos ? text.size() : slash + 1);
  return part;
}

template <typename Number>
bool parse(std::string_view text, int base, Number& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out, base);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::string to_user_data(const PeerName& name) {
  return std::string(kProgram) + "/" + name.cluster + "/" + std::to_string(name.protocol) + "/" +
         std::string(kRoles[static_cast<std::size_t>(name.role)]) + "/" + to_string(name.id);
}

std::optional<PeerName> parse_user_data(std::string_view text) {
  PeerName name;
  if (next_part(text) != kProgram) return std::nullopt;
  name.cluster = next_part(text);
  if (!parse(next_part(text), 10, name.protocol)) return std::nullopt;
  const std::string_view role = next_part(text);
  if (role != kRoles[0] && role != kRoles[1]) return std::nullopt;
  name.role = role == kRoles[0] ? Role::kCoordinator : Role::kWorker;
  if (!parse(text, 16, name.id.value) || name.id.value == 0) return std::nullopt;
  return name;
}

}  // namespace accord::dds
