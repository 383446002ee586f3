// Scenes may be hundreds of megabytes: they travel in pieces that a bus takes.
#pragma once

#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "common/io/wire/bytes.h"
#include "common/io/wire/scene_hash.h"
#include "common/transport/messages.h"

namespace accord {

// The piece that begins at `offset`, as large as a message may hold. Requires: offset <= size.
ScenePiece piece_of(BytesView scene, const SceneHash& hash, std::uint64_t offset);

// Puts one scene together from pieces that come in order, perhaps several times over. Takes memory
// as bytes come, never for what a piece only claims. Not thread safe.
class SceneAssembly {
 public:
  explicit SceneAssembly(const SceneHash& hash) : hash_(hash) {}

  // Pieces of other scenes, and those that do not go on where the last one ended, are passed over:
  // ask for next_offset() when none comes any more.
  void add(const ScenePiece& piece);

  std::uint64_t next_offset() const { return bytes_.size(); }
  bool complete() const { return total_ > 0 && bytes_.size() == total_; }

  // The bytes, or a sentence where they do not have the hash; then it begins anew.
  // Requires: complete().
  tl::expected<Bytes, std::string> take();

 private:
  SceneHash hash_;
  std::uint64_t total_ = 0;
  Bytes bytes_;
};

}  // namespace accord
