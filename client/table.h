// Aligned lines of a name and a value, as commands print their results.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace accord {

class Table {
 public:
  void add(std::string name, std::string value) {
    rows_.emplace_back(std::move(name), std::move(value));
  }

  // A line for each row, names padded to one width.
  std::string str() const;

 private:
  std::vector<std::pair<std::string, std::string>> rows_;
};

}  // namespace accord
