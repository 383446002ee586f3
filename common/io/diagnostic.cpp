#include "common/io/diagnostic.h"

#include <algorithm>

#include "common/io/limits.h"

namespace accord {

std::string to_string(const Diagnostic& diagnostic) {
  std::string out = diagnostic.file;
  if (diagnostic.line > 0) out += ":" + std::to_string(diagnostic.line);
  if (!diagnostic.key.empty()) out += ": " + diagnostic.key;
  return out + ": " + diagnostic.text;
}

void Faults::add(std::string_view file, int line, std::string_view key, std::string_view text) {
  ++found_;
  if (kept_.size() < limits::kFaults) {
    kept_.push_back({std::string(file), line, std::string(key), std::string(text)});
  }
}

bool Faults::full() const {
  return kept_.size() >= limits::kFaults;
}

std::vector<Diagnostic> Faults::take() {
  // Other files keep the order in which they were found.
  std::vector<std::string> files{main_file_};
  for (const Diagnostic& fault : kept_) {
    if (std::ranges::find(files, fault.file) == files.end()) files.push_back(fault.file);
  }
  std::vector<Diagnostic> out;
  for (const std::string& file : files) {
    const auto from = static_cast<std::ptrdiff_t>(out.size());
    std::ranges::copy_if(kept_, std::back_inserter(out),
                         [&](const Diagnostic& fault) { return fault.file == file; });
    std::stable_sort(out.begin() + from, out.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
  }
  out.erase(std::unique(out.begin(), out.end()), out.end());
  if (full()) {
    out.push_back({main_file_, 0, "",
                   "no more than " + std::to_string(limits::kFaults) + " faults are listed"});
  }
  found_ = 0;
  kept_.clear();
  return out;
}

}  // namespace accord
