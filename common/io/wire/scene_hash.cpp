#include "common/io/wire/scene_hash.h"

#include <openssl/evp.h>

#include <stdexcept>

namespace accord {

SceneHash hash_of(BytesView canonical_bytes) {
  SceneHash hash;
  unsigned size = 0;
  if (EVP_Digest(canonical_bytes.data(), canonical_bytes.size(), hash.bytes.data(), &size,
                 EVP_sha256(), nullptr) != 1 ||
      size != hash.bytes.size()) {
    throw std::runtime_error("libcrypto could not work out a SHA-256");
  }
  return hash;
}

std::string to_string(const SceneHash& hash) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out;
  out.reserve(2 * hash.bytes.size());
  for (const std::uint8_t byte : hash.bytes) {
    out += kDigits[byte >> 4U];
    out += kDigits[byte & 15U];
  }
  return out;
}

}  // namespace accord
