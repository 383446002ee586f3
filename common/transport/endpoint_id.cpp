#include "common/transport/endpoint_id.h"

#include <array>
#include <random>
#include <string_view>

namespace accord {

std::string to_string(EndpointId id) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out;
  for (int shift = 60; shift >= 0; shift -= 4) out += kDigits[(id.value >> shift) & 15U];
  return out;
}

EndpointId random_endpoint_id() {
  std::random_device entropy;
  EndpointId id;
  while (id.value == 0) id.value = std::uint64_t{entropy()} << 32U | entropy();
  return id;
}

}  // namespace accord
