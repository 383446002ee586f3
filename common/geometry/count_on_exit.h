// Hands what a query counted to the world when the query ends, whichever way it ends.
#pragma once

#include "common/geometry/advancement.h"
#include "common/geometry/query_counter.h"

namespace accord {

template <int D>
class CountOnExit {
 public:
  CountOnExit(Advancement<D>& work, QueryCounter& counter) : work_(work), counter_(counter) {}
  ~CountOnExit() {
    if (work_.distances != 0) counter_.add(work_.distances);
    work_.distances = 0;
  }
  CountOnExit(const CountOnExit&) = delete;
  CountOnExit& operator=(const CountOnExit&) = delete;

 private:
  Advancement<D>& work_;
  QueryCounter& counter_;
};

}  // namespace accord
