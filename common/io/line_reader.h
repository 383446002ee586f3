// Walks through text line by line, for the formats that are made of lines.
#pragma once

#include <string_view>

namespace accord {

class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  // Moves to the next line; false at the end. Line ends are \n or \r\n.
  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    ++number_;
    return true;
  }

  std::string_view line() const { return line_; }
  int number() const { return number_; }  // of the current line, from 1

 private:
  std::string_view rest_;
  std::string_view line_;
  int number_ = 0;
};

// Takes the next word off the front of `text`; empty at its end.
inline std::string_view take_word(std::string_view& text) {
  constexpr std::string_view kBlank = " \t\r\v\f";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return text = {};
  const std::size_t end = text.find_first_of(kBlank, begin);
  const std::string_view word = text.substr(begin, end - begin);
  text = end == std::string_view::npos ? std::string_view() : text.substr(end);
  return word;
}

}  // namespace accord
