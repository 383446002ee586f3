#include "common/io/request_names.h"

#include <gtest/gtest.h>

#include <string>

namespace accord {
namespace {

TEST(RequestId, HoldsWhatCanStandAnywhere) {
  for (const char* id : {"a", "Z9", "fleet-7:order_12.3", ":", ".."}) {
    EXPECT_TRUE(is_request_id(id)) << id;
  }
  for (const char* id : {"", "a b", "a/b", "a\n", "\xc3\xa4", "a\\", "a'", "a\"", "*"}) {
    EXPECT_FALSE(is_request_id(id)) << id;
  }
  EXPECT_TRUE(is_request_id(std::string(128, 'a')));
  EXPECT_FALSE(is_request_id(std::string(129, 'a')));
  EXPECT_FALSE(is_request_id(std::string_view("a\0b", 3)));
}

TEST(SceneName, IsNoWayOutOfAFolder) {
  for (const char* name : {"depot", "depot-2.v1", "A_b"}) EXPECT_TRUE(is_scene_name(name)) << name;
  for (const char* name : {"", ".", "..", ".depot", "a/b", "/a", "a\\b", "a:b", "~", "a b"}) {
    EXPECT_FALSE(is_scene_name(name)) << name;
  }
}

}  // namespace
}  // namespace accord
