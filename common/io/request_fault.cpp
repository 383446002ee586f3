#include "common/io/request_fault.h"

#include <algorithm>

#include "common/io/limits.h"
#include "common/io/words.h"

namespace accord {
namespace {

constexpr std::size_t kShown = 5;

std::string cut(std::string_view text, std::size_t most) {
  constexpr std::size_t kDots = 6;  // printable() may add these
  return printable(text, most - kDots);
}

std::string place_in_words(const Diagnostic& fault) {
  std::string out = fault.file;
  if (fault.line > 0) out += ":" + std::to_string(fault.line);
  if (!out.empty() && !fault.key.empty()) out += ": ";
  return out + fault.key;
}

}  // namespace

RequestFault request_fault(Rejection reason, const std::vector<Diagnostic>& faults) {
  constexpr std::size_t kRoomForRest = 40;
  constexpr std::size_t kMost = limits::kFaultTextBytes - kRoomForRest;
  std::string text = cut(faults.front().text, kMost);
  std::size_t shown = 1;
  for (; shown < std::min(kShown, faults.size()); ++shown) {
    const std::string place = place_in_words(faults[shown]);
    const std::string next = "; also " + place + (place.empty() ? "" : ": ") + faults[shown].text;
    if (text.size() + next.size() > kMost) break;
    text += next;
  }
  if (shown < faults.size()) {
    const std::size_t rest = faults.size() - shown;
    text += "; and " + std::to_string(rest) + (rest == 1 ? " more fault" : " more faults");
  }
  return {reason, cut(place_in_words(faults.front()), limits::kFaultFieldBytes),
          cut(text, limits::kFaultTextBytes)};
}

RequestFault request_fault(Rejection reason, std::string_view field, std::string_view text) {
  return request_fault(reason, {{"", 0, std::string(field), std::string(text)}});
}

}  // namespace accord
