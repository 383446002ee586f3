// The name of a scene on the wire: SHA-256 over its canonical bytes (scene_codec.h).
//
// SHA-256 of OpenSSL's libcrypto, which Fast DDS brings along: two scenes with one hash would give
// somebody a plan for another's problem, so the hash must hold even where scenes come from people
// who would like that. It costs 1 ms a megabyte at most.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string>

#include "common/io/wire/bytes.h"

namespace accord {

struct SceneHash {
  std::array<std::uint8_t, 32> bytes{};

  friend auto operator<=>(const SceneHash&, const SceneHash&) = default;
};

// Requests go by the same over theirs (request_codec.h).
using RequestHash = SceneHash;

// Thread safe. Throws std::runtime_error where libcrypto refuses to work, as it may for lack of
// memory.
SceneHash hash_of(BytesView canonical_bytes);

// 64 hexadecimal digits.
std::string to_string(const SceneHash& hash);

}  // namespace accord
