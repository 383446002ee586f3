#include "common/io/wire/task_record.h"

#include <algorithm>
#include <string_view>

#include "accord.pb.h"
#include "common/io/limits.h"
#include "common/io/wire/payload_scan.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/wire/subproblem_codec.h"
#include "common/io/words.h"

namespace accord {
namespace {

constexpr std::string_view kKind = "accord task";

// How every record begins: the tag of its first field, its length, and what it is.
bool is_record(BytesView bytes) {
  Bytes start{0x0a, static_cast<std::uint8_t>(kKind.size())};
  start.insert(start.end(), kKind.begin(), kKind.end());
  return bytes.size() >= start.size() && std::ranges::equal(bytes.first(start.size()), start);
}

std::string printable(std::string_view text) {
  std::string out(text.substr(0, limits::kWhyBytes));
  for (std::size_t at = 0; (at = first_unprintable(out)) != std::string::npos;) out[at] = '?';
  return out;
}

BytesView view(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

tl::unexpected<std::string> fault_in(const char* part, const std::string& fault) {
  return tl::unexpected(std::string(part) + ": " + fault);
}

}  // namespace

Bytes encode_task_record(const TaskRecord& record) {
  const auto& [scene, hierarchy, subproblem, why] = record;
  payload::TaskRecord out;
  out.set_kind(std::string(kKind));
  out.set_scene(scene.data(), scene.size());
  out.set_hierarchy(hierarchy.data(), hierarchy.size());
  out.set_subproblem(subproblem.data(), subproblem.size());
  out.set_why(printable(why));
  return serialize_payload(out);
}

tl::expected<RecordedTask, std::string> decode_task_record(BytesView bytes) {
  if (!is_record(bytes)) return tl::unexpected(std::string("not a recorded task"));
  constexpr std::size_t kFields = 5;
  payload::TaskRecord message;
  const ScanLimits limits{limits::kTaskRecordBytes, kFields};
  if (auto fault = parse_payload(bytes, "a recorded task", limits, message)) {
    return tl::unexpected(std::move(*fault));
  }
  RecordedTask out;
  if (message.why().size() > limits::kWhyBytes ||
      first_unprintable(message.why()) != std::string::npos) {
    return fault_in("why", "expected text of at most " + std::to_string(limits::kWhyBytes) +
                               " bytes without control characters");
  }
  out.why = message.why();
  auto scene = decode_scene(view(message.scene()));
  if (!scene) return fault_in("scene", scene.error());
  auto hierarchy = decode_hierarchy(view(message.hierarchy()));
  if (!hierarchy) return fault_in("hierarchy", hierarchy.error());
  auto subproblem = decode_subproblem(view(message.subproblem()), **scene);
  if (!subproblem) return fault_in("subproblem", subproblem.error());
  out.scene = std::move(*scene);
  out.solvers = std::move(hierarchy->solvers);
  out.subproblem = std::move(*subproblem);
  return out;
}

}  // namespace accord
