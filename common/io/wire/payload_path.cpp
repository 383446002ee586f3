#include "common/io/wire/payload_path.h"

namespace accord {

std::string PayloadPath::in_words() const {
  std::string out = parent_ == nullptr ? std::string() : parent_->in_words();
  if (!out.empty() && !name_.empty()) out += '.';
  out += name_;
  if (indexed_) out += "[" + std::to_string(index_) + "]";
  return out;
}

}  // namespace accord
