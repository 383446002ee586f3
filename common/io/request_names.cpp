#include "common/io/request_names.h"

#include <algorithm>

#include "common/io/limits.h"

namespace accord {
namespace {

static_assert(limits::kRequestIdBytes == 128 && limits::kNameBytes == 200, "as said in words");

// Whatever the locale.
bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool consists_of(std::string_view text, std::string_view others, std::size_t most) {
  return !text.empty() && text.size() <= most && std::ranges::all_of(text, [&](char c) {
    return is_letter_or_digit(c) || others.find(c) != std::string_view::npos;
  });
}

}  // namespace

bool is_request_id(std::string_view text) {
  return consists_of(text, "-_.:", limits::kRequestIdBytes);
}

bool is_scene_name(std::string_view text) {
  return consists_of(text, "-_.", limits::kNameBytes) && text.front() != '.';
}

}  // namespace accord
