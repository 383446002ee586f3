// Where a value stands in a payload, as in "robots[4].start", put into words only when asked for.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace accord {

// Lives on the stack of the function that looks at the value, below that of its parent.
class PayloadPath {
 public:
  explicit PayloadPath(std::string_view root) : name_(root) {}
  PayloadPath(std::string_view root, std::size_t index)
      : name_(root), index_(index), indexed_(true) {}
  PayloadPath(const PayloadPath& parent, std::string_view name) : parent_(&parent), name_(name) {}
  PayloadPath(const PayloadPath& parent, std::string_view name, std::size_t index)
      : parent_(&parent), name_(name), index_(index), indexed_(true) {}
  // A parent has to live on.
  PayloadPath(PayloadPath&&, std::string_view) = delete;
  PayloadPath(PayloadPath&&, std::string_view, std::size_t) = delete;

  std::string in_words() const;

 private:
  const PayloadPath* parent_ = nullptr;
  std::string_view name_;  // empty for the place of a number in a list
  std::size_t index_ = 0;
  bool indexed_ = false;
};

}  // namespace accord
