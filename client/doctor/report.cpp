#include "client/doctor/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "client/terminal_text.h"

namespace accord {
namespace {

constexpr std::size_t kLongest = 4000;  // of a text

std::string plain(const std::string& text) {
  return terminal_text(text, kLongest);
}

}  // namespace

void write_text(const std::vector<Finding>& findings, std::ostream& out) {
  for (const Finding& finding : findings) {
    out << fmt::format("{:<8} {:<18} {}\n", name_of(finding.severity), name_of(finding.concern),
                       plain(finding.seen));
    if (!finding.why.empty()) out << "    why      " << plain(finding.why) << "\n";
    for (const std::string& command : finding.mend) {
      out << "    mend     " << plain(command) << "\n";
    }
  }
}

void write_json(const std::vector<Finding>& findings, std::ostream& out) {
  for (const Finding& finding : findings) {
    nlohmann::ordered_json object;
    object["severity"] = name_of(finding.severity);
    object["code"] = name_of(finding.concern);
    object["seen"] = plain(finding.seen);
    object["why"] = plain(finding.why);
    object["mend"] = nlohmann::ordered_json::array();
    for (const std::string& command : finding.mend) object["mend"].push_back(plain(command));
    out << object.dump() << "\n";
  }
}

}  // namespace accord
