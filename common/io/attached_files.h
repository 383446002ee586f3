// The files that came with a request, as a scene that came with it finds them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "common/io/file_source.h"
#include "common/model/plan_request.h"

namespace accord {

// The name of an attachment in the one form that all ways of writing it have: "a/b.stl" for
// "./a//b.stl". Or what is wrong with it: it leaves the folder that the scene would lie in, or is
// no name of a file.
tl::expected<std::string, std::string> attachment_name(std::string_view name);

// Thread safe. The attachments must outlive it.
class AttachedFiles final : public FileSource {
 public:
  // Requires: names are sound (attachment_name()) and no two the same.
  explicit AttachedFiles(const std::vector<PlanRequest::Attachment>& attachments);

  bool exists(const std::filesystem::path& path) const override { return is_file(path); }
  bool is_file(const std::filesystem::path& path) const override;
  tl::expected<std::string, std::string> read(const std::filesystem::path& path,
                                              std::size_t max_bytes) const override;

 private:
  std::map<std::string, const std::string*> contents_;  // by normal name
};

}  // namespace accord
