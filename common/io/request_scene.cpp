#include "common/io/request_scene.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "common/io/attached_files.h"
#include "common/io/fields.h"
#include "common/io/files.h"
#include "common/io/request_names.h"
#include "common/io/request_queries.h"
#include "common/io/scene_file.h"
#include "common/io/words.h"

namespace accord {
namespace {

namespace fs = std::filesystem;
using Loaded = tl::expected<std::shared_ptr<const Scene>, RequestFault>;
using Found = std::optional<RequestFault>;

std::string indexed(std::string_view list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

// ---- Size ----

// No less than the bytes it is encoded in (request_codec.h).
std::size_t size_of(const PlanRequest& request) {
  constexpr std::size_t kPart = 16;  // what may stand before a text or a list
  const auto configuration = [](const std::optional<Configuration>& q) {
    return q ? kPart + sizeof(double) * q->size() : 0;
  };
  std::size_t size = 10 * kPart + request.id.size() + request.scene_text.size() +
                     request.scene_name.size() + request.method.size();
  for (const auto& [name, content] : request.attachments) {
    size += 3 * kPart + name.size() + content.size();
  }
  for (const auto& [robot, start, goal] : request.queries) {
    size += 2 * kPart + robot.size() + configuration(start) + configuration(goal);
  }
  for (const std::string& solver : request.solvers) size += kPart + solver.size();
  return size;
}

Found check_size(const PlanRequest& request, const RequestLimits& limits) {
  std::size_t attached = 0;
  for (const auto& attachment : request.attachments) attached += attachment.content.size();
  struct Part {
    std::string_view field;
    std::size_t size;
    std::size_t most;
    std::string_view unit;
  };
  for (const auto& [field, size, most, unit] :
       {Part{"scene_text", request.scene_text.size(), limits::kSceneBytes, "bytes"},
        Part{"attachments", request.attachments.size(), limits::kAttachments, "files"},
        Part{"attachments", attached, limits::kAttachmentBytes, "bytes together"},
        Part{"queries", request.queries.size(), limits::kRobots, "queries"},
        Part{"solvers", request.solvers.size(), limits::kSolvers, "solvers"},
        Part{"", size_of(request), std::min(limits.bytes, limits::kRequestBytes),
             "bytes in all"}}) {
    if (size <= most) continue;
    return request_fault(Rejection::kTooLarge, field,
                         "expected at most " + std::to_string(most) + " " + std::string(unit) +
                             ", not " + std::to_string(size));
  }
  return std::nullopt;
}

// ---- Options ----

Found check_choice(std::string_view what, const std::string& name,
                   const std::vector<std::string>& choices, const std::string& field) {
  if (std::ranges::find(choices, name) != choices.end()) return std::nullopt;
  const std::vector<std::string_view> known(choices.begin(), choices.end());
  const std::string expected = known.empty() ? "" : "; expected " + alternatives(known);
  return request_fault(Rejection::kBadOption, field,
                       "there is no " + std::string(what) + " " + in_quotes(name) + expected);
}

Found check_options(const PlanRequest& request, const RequestLimits& limits) {
  if (auto fault = check_choice("method", request.method, limits.methods, "method")) return fault;
  const auto& solvers = request.solvers;
  for (std::size_t i = 0; i < solvers.size(); ++i) {
    const std::string field = indexed("solvers", i);
    if (auto fault = check_choice("solver", solvers[i], limits.solvers, field)) return fault;
    const auto end = solvers.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(solvers.begin(), end, solvers[i]) != end) {
      return request_fault(Rejection::kBadOption, field, in_quotes(solvers[i]) + " is there twice");
    }
  }
  constexpr Range kRange{0, limits::kDeadline, "s"};
  if (request.deadline >= kRange.min && request.deadline <= kRange.max) return std::nullopt;
  return request_fault(Rejection::kBadOption, "deadline",
                       "expected " + in_words(kRange) + ", not " + in_words(request.deadline));
}

// ---- The scene ----

Loaded loaded(SceneResult result) {
  if (result.scene) return std::move(result.scene);
  return tl::unexpected(request_fault(Rejection::kBadScene, result.faults));
}

Loaded refuse(Rejection reason, std::string_view field, std::string_view text) {
  return tl::unexpected(request_fault(reason, field, text));
}

Loaded load_attached(const PlanRequest& request) {
  if (!request.scene_name.empty() && !is_name(request.scene_name)) {
    return refuse(Rejection::kBadScene, "scene_name",
                  "expected a name of at most " + std::to_string(limits::kNameBytes) +
                      " bytes without control characters, not " + in_quotes(request.scene_name));
  }
  Faults faults("");
  std::unordered_map<std::string, std::size_t> names;  // with the place of the first
  for (std::size_t i = 0; i < request.attachments.size(); ++i) {
    const std::string at = indexed("attachments", i) + ".name";
    const auto name = attachment_name(request.attachments[i].name);
    if (!name) {
      faults.add("", 0, at, name.error());
    } else if (const auto [first, is_new] = names.emplace(*name, i); !is_new) {
      faults.add("", 0, at,
                 in_quotes(*name) + " is the name of " + indexed("attachments", first->second) +
                     " already");
    }
  }
  if (faults.count() > 0) {
    return tl::unexpected(request_fault(Rejection::kBadScene, faults.take()));
  }
  return loaded(parse_scene(request.scene_text, "scene", ".", AttachedFiles(request.attachments),
                            request.scene_name));
}

Loaded load_stored(const PlanRequest& request, const fs::path& folder) {
  const std::string& name = request.scene_name;
  if (!request.attachments.empty()) {
    return refuse(Rejection::kBadScene, "attachments",
                  "a scene in store has files of its own; expected none");
  }
  if (!is_scene_name(name)) {
    return refuse(Rejection::kUnknownScene, "scene_name",
                  "expected " + std::string(kSceneNameInWords) + ", not " + in_quotes(name));
  }
  if (folder.empty()) {
    return refuse(Rejection::kUnknownScene, "scene_name",
                  "this service has no scenes in store; send the scene's text");
  }
  const fs::path path = folder / (name + ".yaml");
  if (!file_system().is_file(path)) {
    return refuse(Rejection::kUnknownScene, "scene_name",
                  "there is no scene " + in_quotes(name) + " in store");
  }
  const auto text = read_file(path, limits::kSceneBytes);
  if (!text) return refuse(Rejection::kBadScene, "scene_name", text.error());
  // Where the store lies is not the sender's business.
  return loaded(parse_scene(*text, path.filename().string(), folder));
}

Loaded load_scene_of(const PlanRequest& request, const fs::path& stored_scenes) {
  if (request.scene_text.empty() && request.scene_name.empty()) {
    return refuse(Rejection::kBadScene, "scene_text",
                  "expected a scene's text, or else the name of one in store");
  }
  return request.scene_text.empty() ? load_stored(request, stored_scenes) : load_attached(request);
}

}  // namespace

Loaded load_request(const PlanRequest& request, const fs::path& stored_scenes,
                    const RequestLimits& limits) {
  if (!is_request_id(request.id)) {
    return refuse(Rejection::kBadId, "id",
                  "expected " + std::string(kRequestIdInWords) + ", not " + in_quotes(request.id));
  }
  if (auto fault = check_size(request, limits)) return tl::unexpected(std::move(*fault));
  if (auto fault = check_options(request, limits)) return tl::unexpected(std::move(*fault));
  Loaded scene = load_scene_of(request, stored_scenes);
  if (!scene) return scene;
  if ((*scene)->robots.size() > limits.robots) {
    return refuse(Rejection::kTooLarge, request.scene_text.empty() ? "scene_name" : "scene_text",
                  "expected at most " + std::to_string(limits.robots) + " robots, not " +
                      std::to_string((*scene)->robots.size()));
  }
  return with_queries(std::move(*scene), request.queries);
}

}  // namespace accord
