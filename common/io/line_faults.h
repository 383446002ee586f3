// The faults of a file that is made of lines: a mesh or a map. One of another kind altogether has a
// fault in every line: only the first few are listed, so that they leave room for other files'.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "common/io/diagnostic.h"
#include "common/io/limits.h"
#include "common/io/line_reader.h"

namespace accord {

// Reports faults with the line at which `lines` stands. All three must outlive it.
class LineFaults {
 public:
  LineFaults(const LineReader& lines, const std::string& file, Faults& faults)
      : lines_(lines), file_(file), faults_(faults) {}

  void add(std::string_view text, std::string_view key = "") {
    put(text, key);
    if (count_ < limits::kLineFaults) return;
    give_up("no more than " + std::to_string(limits::kLineFaults) + " faults of a file are listed");
  }

  // Reports what makes it pointless to read on.
  void give_up(std::string_view text, std::string_view key = "") {
    put(text, key);
    over_ = true;
  }

  bool any() const { return count_ > 0; }
  bool over() const { return over_; }  // read no further

 private:
  void put(std::string_view text, std::string_view key) {
    faults_.add(file_, std::max(1, lines_.number()), key, text);  // an empty file has no line yet
    ++count_;
  }

  const LineReader& lines_;
  const std::string& file_;
  Faults& faults_;
  std::size_t count_ = 0;
  bool over_ = false;
};

}  // namespace accord
