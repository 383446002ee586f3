#include "common/io/wire/scene_hash.h"

#include <gtest/gtest.h>

namespace accord {
namespace {

TEST(SceneHash, IsSha256) {
  // The example of FIPS 180-4.
  const Bytes abc{'a', 'b', 'c'};
  EXPECT_EQ(to_string(hash_of(abc)),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(to_string(hash_of({})),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace accord
