#include "client/fleet/request_file.h"

#include <filesystem>
#include <map>
#include <utility>

#include "common/io/file_source.h"
#include "common/io/files.h"
#include "common/io/limits.h"
#include "common/io/scene_file.h"

namespace accord {
namespace {

// The files of this machine, and a note of those that were read.
class NotedFiles final : public FileSource {
 public:
  explicit NotedFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  bool exists(const std::filesystem::path& path) const override {
    return file_system().exists(path);
  }
  bool is_file(const std::filesystem::path& path) const override {
    return file_system().is_file(path);
  }
  tl::expected<std::string, std::string> read(const std::filesystem::path& path,
                                              std::size_t max_bytes) const override {
    auto content = file_system().read(path, max_bytes);
    if (content) read_[path.lexically_relative(folder_).generic_string()] = *content;
    return content;
  }

  std::vector<PlanRequest::Attachment> take() {
    std::vector<PlanRequest::Attachment> files;
    for (auto& [name, content] : read_) files.push_back({name, std::move(content)});
    return files;
  }

 private:
  std::filesystem::path folder_;
  mutable std::map<std::string, std::string> read_;
};

}  // namespace

RequestFile request_for_scene(const std::string& path) {
  RequestFile out;
  auto text = read_file(path, limits::kSceneBytes);
  if (!text) {
    out.faults.push_back({path, 0, "", text.error()});
    return out;
  }
  std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) folder = ".";
  NotedFiles files(folder);
  SceneResult read = parse_scene(*text, path, folder, files);
  out.scene = std::move(read.scene);
  out.faults = std::move(read.faults);
  if (out.scene) out.request.scene_name = out.scene->name;
  out.request.scene_text = std::move(*text);
  out.request.attachments = files.take();
  return out;
}

}  // namespace accord
