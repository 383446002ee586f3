// What is wrong with a file, for the person who wrote it, and the collector of such faults.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace accord {

// One fault. `key` is the path of the offending value, as in robots[4].goal.
struct Diagnostic {
  std::string file;
  int line;          // from 1; 0: the file as a whole
  std::string key;   // empty where no key is to blame
  std::string text;  // what is wrong and what was expected

  friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

// "file:line: key: text", without the parts that are empty. Always one line.
std::string to_string(const Diagnostic& diagnostic);

// Where something stands in a file, for whoever may have to blame it.
struct Place {
  std::string file;
  int line;
  std::string key;
};

// Reports a fault at a place that is worked out only then: paths cost time.
using Blame = std::function<void(std::string_view text)>;

// Gathers the faults of one load, so that all can be reported at once. Not thread safe.
class Faults {
 public:
  // `main_file` is listed first, whatever was found first.
  explicit Faults(std::string main_file) : main_file_(std::move(main_file)) {}

  void add(std::string_view file, int line, std::string_view key, std::string_view text);
  void add(const Place& place, std::string_view text) {
    add(place.file, place.line, place.key, text);
  }

  std::size_t count() const { return found_; }
  // No more will be listed: whoever looks for many may stop looking.
  bool full() const;

  // The faults in order of file and line, each once; a last one says so if there was no room for
  // more. Leaves the collector empty.
  std::vector<Diagnostic> take();

 private:
  std::string main_file_;
  std::size_t found_ = 0;
  std::vector<Diagnostic> kept_;
};

}  // namespace accord
