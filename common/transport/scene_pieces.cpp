#include "common/transport/scene_pieces.h"

#include <algorithm>

#include "common/transport/message_limits.h"

namespace accord {

ScenePiece piece_of(BytesView scene, const SceneHash& hash, std::uint64_t offset) {
  const BytesView data = scene.subspan(offset, std::min(kPieceBytes, scene.size() - offset));
  return {hash, scene.size(), offset, Bytes(data.begin(), data.end())};
}

void SceneAssembly::add(const ScenePiece& piece) {
  if (piece.scene != hash_ || piece.offset != bytes_.size() || message_fault(piece)) return;
  if (bytes_.empty()) total_ = piece.total;
  if (piece.total != total_) return;
  bytes_.insert(bytes_.end(), piece.data.begin(), piece.data.end());
}

tl::expected<Bytes, std::string> SceneAssembly::take() {
  Bytes out = std::move(bytes_);
  bytes_ = {};
  total_ = 0;
  if (hash_of(out) == hash_) return out;
  return tl::unexpected("the scene that came does not have the hash " + to_string(hash_));
}

}  // namespace accord
