// Whether and how paths are published for ROS 2, beside the public topics.
#pragma once

#include <string>

namespace accord {

struct RosOptions {
  std::string name;  // that their topics' names begin with, as in "accord"; empty: none are
  std::string frame = "map";  // the scene's coordinate frame, as ROS calls it
};

}  // namespace accord
