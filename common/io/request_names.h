// What requests, and scenes in store, may be called. Pure functions; thread safe.
#pragma once

#include <string_view>

namespace accord {

// 1 to kRequestIdBytes (limits.h) of A-Z a-z 0-9 - _ . : so that ids can stand in logs, commands
// and addresses as they are.
bool is_request_id(std::string_view text);
inline constexpr std::string_view kRequestIdInWords =
    "1 to 128 letters, digits, '-', '_', '.' and ':'";

// 1 to kNameBytes of A-Z a-z 0-9 - _ . not beginning with a dot: part of a file's name, and no way
// out of its folder.
bool is_scene_name(std::string_view text);
inline constexpr std::string_view kSceneNameInWords =
    "1 to 200 letters, digits, '-', '_' and '.', not beginning with '.'";

}  // namespace accord
