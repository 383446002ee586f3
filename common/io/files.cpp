#include "common/io/files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <system_error>

#include "common/io/words.h"

namespace accord {

namespace fs = std::filesystem;

tl::expected<std::string, std::string> read_file(const fs::path& path, std::size_t max_bytes) {
  const std::string cannot = "cannot open " + path_in_quotes(path) + ": ";
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return tl::unexpected(cannot + "no such file");
  if (error) return tl::unexpected(cannot + error.message());
  if (fs::is_directory(status)) return tl::unexpected(cannot + "it is a folder");
  if (!fs::is_regular_file(status)) return tl::unexpected(cannot + "it is not a regular file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return tl::unexpected(cannot + "permission denied");
  std::string bytes;
  std::array<char, 65536> chunk{};
  while (stream.read(chunk.data(), chunk.size()) || stream.gcount() > 0) {
    bytes.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
    if (bytes.size() > max_bytes) return tl::unexpected(too_large(path, max_bytes));
  }
  if (stream.bad()) return tl::unexpected(cannot + "it cannot be read");
  return bytes;
}

tl::expected<fs::path, std::string> resolve(std::string_view reference, const fs::path& folder) {
  if (reference.find("://") != std::string_view::npos) {
    return tl::unexpected("expected a path relative to this file's folder, not the URL " +
                          in_quotes(reference));
  }
  const fs::path path(reference);
  if (path.is_absolute()) {
    return tl::unexpected("expected a path relative to this file's folder, not the absolute " +
                          in_quotes(reference));
  }
  return folder / path;
}

std::string too_large(const fs::path& path, std::size_t max_bytes) {
  return path_in_quotes(path) + " is too large; expected at most " +
         std::to_string(max_bytes >> 20U) + " MiB";
}

std::string path_in_quotes(const fs::path& path) {
  constexpr std::size_t kLongest = 4096;  // bytes: what Linux takes for a path
  return in_quotes(path.string(), kLongest);
}

std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace accord
