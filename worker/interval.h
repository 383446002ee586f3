// A closed interval of time.
#pragma once

namespace accord {

struct Interval {
  double lo;  // s
  double hi;  // s; may be infinite
};

}  // namespace accord
