// Where the files come from that a scene names, and those that these name in turn: the seam between
// the readers of formats and what lies below. Two implementations: the file system, and the
// attachments of a request (attached_files.h).
//
// Thread safe. Nothing throws but std::bad_alloc.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>

namespace accord {

class FileSource {
 public:
  FileSource() = default;
  virtual ~FileSource() = default;
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;

  // Whether there is something of that name, and whether it is a file that may be read.
  virtual bool exists(const std::filesystem::path& path) const = 0;
  virtual bool is_file(const std::filesystem::path& path) const = 0;
  // The bytes of a file of at most `max_bytes`, or why there are none, as in
  // "cannot open "rack.stl": no such file".
  virtual tl::expected<std::string, std::string> read(const std::filesystem::path& path,
                                                      std::size_t max_bytes) const = 0;
};

// The files of this machine, read as read_file() (files.h) does.
const FileSource& file_system();

}  // namespace accord
