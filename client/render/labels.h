// Places names in a picture so that all that are written can be read.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "client/render/svg.h"

namespace accord {

class Labels {
 public:
  explicit Labels(Svg& svg) : svg_(svg) {}

  // Writes the name about `centre` (pixels) in letters of that size, unless it would run into one
  // that is there already: those that matter more come first.
  void write(const Vec2& centre, const std::string& name, double size, std::string_view attributes);

  // The largest letters with which the name is no wider than `room` (pixels).
  static double size_for(const std::string& name, double room);

 private:
  struct Box {
    Vec2 low;
    Vec2 high;
  };

  Svg& svg_;
  std::vector<Box> taken_;
};

}  // namespace accord
