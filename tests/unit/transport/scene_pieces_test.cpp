#include "common/transport/scene_pieces.h"

#include <gtest/gtest.h>

#include "common/transport/message_limits.h"

namespace accord {
namespace {

Bytes scene() {
  Bytes bytes(2 * kPieceBytes + 5);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 7 >> 3U);
  return bytes;
}

TEST(SceneAssembly, PutsPiecesTogetherThatComeTwiceOrTooEarly) {
  const Bytes bytes = scene();
  const SceneHash hash = hash_of(bytes);
  SceneAssembly assembly(hash);
  assembly.add(piece_of(bytes, hash, kPieceBytes));
  EXPECT_EQ(assembly.next_offset(), 0);
  while (!assembly.complete()) {
    const ScenePiece piece = piece_of(bytes, hash, assembly.next_offset());
    assembly.add(piece);
    assembly.add(piece);
  }
  EXPECT_EQ(assembly.take(), bytes);
}

TEST(SceneAssembly, RefusesBytesThatDoNotHaveTheHash) {
  Bytes bytes = scene();
  const SceneHash hash = hash_of(bytes);
  bytes[100] ^= 1U;
  SceneAssembly assembly(hash);
  while (!assembly.complete()) assembly.add(piece_of(bytes, hash, assembly.next_offset()));
  EXPECT_FALSE(assembly.take());
  EXPECT_EQ(assembly.next_offset(), 0);
}

TEST(SceneAssembly, PassesOverPiecesThatContradictEachOther) {
  const Bytes bytes = scene();
  const SceneHash hash = hash_of(bytes);
  SceneAssembly assembly(hash);
  assembly.add(piece_of(bytes, hash, 0));
  ScenePiece longer = piece_of(bytes, hash, kPieceBytes);
  ++longer.total;
  assembly.add(longer);
  ScenePiece beyond = piece_of(bytes, hash, kPieceBytes);
  beyond.total = 10;
  assembly.add(beyond);
  EXPECT_EQ(assembly.next_offset(), kPieceBytes);
}

}  // namespace
}  // namespace accord
