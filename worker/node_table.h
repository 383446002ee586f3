// A value for each node of a roadmap, in memory that a thread keeps from one search to the next: a
// search that meets a hundred nodes of a hundred thousand pays for the hundred.
// Not thread safe; each thread's own.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "worker/shared_roadmap.h"

namespace accord {

template <class Value>
class NodeTable {
 public:
  using Node = SharedRoadmap::Node;

  // All nodes below `nodes` have the value Value{}.
  explicit NodeTable(std::size_t nodes) : memory_(borrow()) {
    if (memory_->cells.size() < nodes) memory_->cells.resize(nodes);
    if (++memory_->now == 0) {  // the count of searches has gone round
      for (Cell& cell : memory_->cells) cell.written = 0;
      memory_->now = 1;
    }
  }
  ~NodeTable() {
    if (memory_) spare().push_back(std::move(memory_));
  }
  NodeTable(NodeTable&&) noexcept = default;
  NodeTable& operator=(NodeTable&&) = delete;
  NodeTable(const NodeTable&) = delete;
  NodeTable& operator=(const NodeTable&) = delete;

  Value& operator[](Node node) {
    Cell& cell = memory_->cells[node];
    if (cell.written != memory_->now) cell = {Value{}, memory_->now};
    return cell.value;
  }

 private:
  struct Cell {
    Value value;
    std::uint32_t written = 0;  // by which search
  };
  struct Memory {
    std::vector<Cell> cells;
    std::uint32_t now = 0;
  };

  static std::vector<std::unique_ptr<Memory>>& spare() {
    thread_local std::vector<std::unique_ptr<Memory>> spare;
    return spare;
  }
  static std::unique_ptr<Memory> borrow() {
    if (spare().empty()) return std::make_unique<Memory>();
    std::unique_ptr<Memory> memory = std::move(spare().back());
    spare().pop_back();
    return memory;
  }

  std::unique_ptr<Memory> memory_;
};

}  // namespace accord
