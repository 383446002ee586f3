// Findings for people and for programs. What they quote of the network is escaped.
#pragma once

#include <ostream>
#include <vector>

#include "client/doctor/finding.h"

namespace accord {

// A paragraph for each fault and warning, then a line for each concern that is fine.
void write_text(const std::vector<Finding>& findings, std::ostream& out);

// An object of JSON a line: severity, code, seen, why, mend.
void write_json(const std::vector<Finding>& findings, std::ostream& out);

}  // namespace accord
