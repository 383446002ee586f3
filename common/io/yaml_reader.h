// YAML text to a Document, with positions and within limits (limits.h).
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "common/io/diagnostic.h"
#include "common/io/document.h"

namespace accord {

// Reads one YAML document. A fault of syntax is reported, and null returned: nothing can be said
// about what follows it. Refused besides: anchors and aliases (a few of them can stand for a
// document without end) and tags, of which all are reported; keys that are no scalars, a second
// document, text that is not UTF-8 or holds control characters, more than kNesting levels, more
// than `max_values` keys and values. Does not throw but for std::bad_alloc. Thread safe.
std::unique_ptr<const Document> read_yaml(std::string_view text, const std::string& file,
                                          std::size_t max_values, Faults& faults);

}  // namespace accord
