#include "coordinator/service/quarantine.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "common/io/files.h"
#include "common/io/wire/task_record.h"

namespace accord {

std::string keep_task(const std::filesystem::path& folder, const std::string& request,
                      const TaskFailure& failure) {
  if (folder.empty()) return "";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  // A request fails of one task only.
  const std::filesystem::path path = folder / (request + ".task");
  const Bytes bytes = encode_task_record(failure.record());
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  std::ranges::copy(bytes, std::ostreambuf_iterator<char>(file));
  file.close();
  if (!file) return "; its input could not be written to " + path_in_quotes(path);
  return "; accord replay " + path_in_quotes(path) + " tries it again";
}

}  // namespace accord
