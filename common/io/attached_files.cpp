#include "common/io/attached_files.h"

#include <algorithm>

#include "common/io/files.h"
#include "common/io/limits.h"
#include "common/io/words.h"

namespace accord {
namespace {

std::string normal(const std::filesystem::path& path) {
  return path.lexically_normal().string();
}

}  // namespace

tl::expected<std::string, std::string> attachment_name(std::string_view name) {
  const auto refuse = [&](const std::string& expected) {
    return tl::unexpected("expected " + expected + ", not " + in_quotes(name));
  };
  if (name.empty() || name.size() > limits::kNameBytes) {
    return refuse("a name of 1 to " + std::to_string(limits::kNameBytes) + " bytes");
  }
  if (name.find_first_of("\t\r\n") != std::string_view::npos ||
      first_unprintable(name) != std::string_view::npos) {
    return refuse("UTF-8 without control characters");
  }
  const std::filesystem::path path(name);
  const bool climbs = std::ranges::find(path, "..") != path.end();
  if (path.is_absolute() || climbs || name.find("://") != std::string_view::npos) {
    return refuse("a path below the scene's folder, without \"..\"");
  }
  if (!path.has_filename() || path.filename() == ".") return refuse("the name of a file");
  return normal(path);
}

AttachedFiles::AttachedFiles(const std::vector<PlanRequest::Attachment>& attachments) {
  for (const auto& [name, content] : attachments) contents_.emplace(normal(name), &content);
}

bool AttachedFiles::is_file(const std::filesystem::path& path) const {
  return contents_.contains(normal(path));
}

tl::expected<std::string, std::string> AttachedFiles::read(const std::filesystem::path& path,
                                                           std::size_t max_bytes) const {
  const auto found = contents_.find(normal(path));
  if (found == contents_.end()) {
    std::vector<std::string_view> known;
    for (const auto& [name, content] : contents_) known.push_back(name);
    return tl::unexpected(path_in_quotes(path) + " is not attached" +
                          suggestion(path.string(), known));
  }
  if (found->second->size() > max_bytes) return tl::unexpected(too_large(path, max_bytes));
  return *found->second;
}

}  // namespace accord
