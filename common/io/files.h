// Reading files whole, within a size, and finding the files that scenes name.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace accord {

// The bytes of a regular file of at most `max_bytes`, or why there are none, as in
// "cannot open "rack.stl": no such file". Never blocks: pipes and devices are refused.
tl::expected<std::string, std::string> read_file(const std::filesystem::path& path,
                                                 std::size_t max_bytes);

// Where a file named in another one lies: relative to `folder`, the folder of the naming file.
// Absolute paths and URLs are refused, so that a scene can move with its folder.
tl::expected<std::filesystem::path, std::string> resolve(std::string_view reference,
                                                         const std::filesystem::path& folder);

// That a file is, as in `"rack.stl" is too large; expected at most 64 MiB`.
std::string too_large(const std::filesystem::path& path, std::size_t max_bytes);

// In quotes, whole: a path that is cut does not say which file it is.
std::string path_in_quotes(const std::filesystem::path& path);

// The extension in lower case, as in ".stl".
std::string extension_of(const std::filesystem::path& path);

}  // namespace accord
