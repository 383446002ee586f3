#include "common/io/file_source.h"

#include <system_error>

#include "common/io/files.h"

namespace accord {
namespace {

class FileSystem final : public FileSource {
 public:
  bool exists(const std::filesystem::path& path) const override {
    std::error_code error;
    return std::filesystem::exists(path, error);
  }
  bool is_file(const std::filesystem::path& path) const override {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
  }
  tl::expected<std::string, std::string> read(const std::filesystem::path& path,
                                              std::size_t max_bytes) const override {
    return read_file(path, max_bytes);
  }
};

}  // namespace

const FileSource& file_system() {
  static const FileSystem files;
  return files;
}

}  // namespace accord
