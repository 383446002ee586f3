// Why a request is not taken in, for the one who sent it.
#pragma once

#include <string>
#include <vector>

#include "common/io/diagnostic.h"
#include "common/model/request_state.h"

namespace accord {

struct RequestFault {
  Rejection reason = Rejection::kNone;
  // Where the first fault is, as in "queries[2].start" or "scene:12: robots[3].goal"; empty: the
  // request as a whole. At most kFaultFieldBytes (limits.h).
  std::string field;
  // What is wrong there and what was expected, and up to four more faults with their places. One
  // line of UTF-8 of at most kFaultTextBytes.
  std::string text;

  friend bool operator==(const RequestFault&, const RequestFault&) = default;
};

// Requires: there is a fault.
RequestFault request_fault(Rejection reason, const std::vector<Diagnostic>& faults);
RequestFault request_fault(Rejection reason, std::string_view field, std::string_view text);

}  // namespace accord
