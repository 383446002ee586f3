// What attempts come to and what they cost on this machine. Each is carried out once, when it is
// first asked for; crews of any number of hands are simulated from the same book.
// Not thread safe.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "coordinator/crew.h"
#include "worker/worker.h"

namespace accord::bench {

struct Entry {
  Resolution resolution;
  double seconds = 0;  // of processor time
};

class CostBook {
 public:
  // The world must outlive this.
  explicit CostBook(const CollisionWorld& world) : worker_(world) {}

  const Entry& of(const Attempt& attempt);

 private:
  using Key = std::pair<std::vector<std::string>, std::vector<std::uint8_t>>;

  Worker worker_;
  std::map<Key, Entry> entries_;
};

}  // namespace accord::bench
