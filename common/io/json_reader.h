// JSON text to a Document, with positions and within limits (limits.h).
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "common/io/diagnostic.h"
#include "common/io/document.h"

namespace accord {

// Reads one JSON value (RFC 8259, strictly: no comments, no NaN). A fault of syntax is reported,
// and null returned. Refused besides: more than kNesting levels, more than `max_values` keys and
// values. Does not throw but for std::bad_alloc. Thread safe.
std::unique_ptr<const Document> read_json(std::string_view text, const std::string& file,
                                          std::size_t max_values, Faults& faults);

}  // namespace accord
