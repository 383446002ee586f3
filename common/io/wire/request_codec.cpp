#include "common/io/wire/request_codec.h"

#include "accord.pb.h"
#include "common/io/request_names.h"
#include "common/io/wire/payload_scan.h"
#include "common/io/wire/trajectory_parts.h"
#include "common/io/words.h"

namespace accord {
namespace {

// ---- To bytes. Structured bindings, so that a field that is added cannot be forgotten here. ----

void put(const PlanRequest::Attachment& attachment, payload::Attachment& out) {
  const auto& [name, content] = attachment;
  out.set_name(name);
  out.set_content(content);
}

void put(const PlanRequest::Query& query, payload::Query& out) {
  const auto& [robot, start, goal] = query;
  out.set_robot(robot);
  // Set, even where it is empty: that is not the same as none.
  if (start) put_numbers(*start, *out.mutable_start()->mutable_value());
  if (goal) put_numbers(*goal, *out.mutable_goal()->mutable_value());
}

// ---- From bytes ----

class RequestDecoder {
 public:
  const std::optional<std::string>& fault() const { return inspector_.fault(); }

  // Takes the texts out of the message.
  bool take(payload::PlanRequest& from, PlanRequest& out) {
    out.id = from.id();
    out.method = from.method();
    out.seed = from.seed();
    out.deadline = from.deadline();
    out.priority = from.priority();
    return take_id(out.id) && take_scene(from, out) && take_attachments(from, out) &&
           take_queries(from, out) &&
           inspector_.name(out.method, PayloadPath("method"), limits::kSolverNameBytes) &&
           take_solvers(from, out) &&
           inspector_.number(out.deadline, {0, limits::kDeadline, "s"}, PayloadPath("deadline"));
  }

 private:
  bool take_id(const std::string& id) {
    return is_request_id(id) ||
           inspector_.fail(PayloadPath("id"),
                           "expected " + std::string(kRequestIdInWords) + ", not " + in_quotes(id));
  }

  bool take_scene(payload::PlanRequest& from, PlanRequest& out) {
    out.scene_text = std::move(*from.mutable_scene_text());
    out.scene_name = from.scene_name();
    return inspector_.count(out.scene_text.size(), 0, limits::kSceneBytes, "bytes",
                            PayloadPath("scene_text")) &&
           (out.scene_name.empty() || inspector_.name(out.scene_name, PayloadPath("scene_name")));
  }

  bool take_attachments(payload::PlanRequest& from, PlanRequest& out) {
    const PayloadPath attachments("attachments");
    const auto size = static_cast<std::size_t>(from.attachments_size());
    if (!inspector_.count(size, 0, limits::kAttachments, "", attachments)) return false;
    std::size_t bytes = 0;
    for (payload::Attachment& one : *from.mutable_attachments()) {
      const PayloadPath at("attachments", out.attachments.size());
      if (!inspector_.name(one.name(), PayloadPath(at, "name"))) return false;
      bytes += one.content().size();
      out.attachments.push_back({one.name(), std::move(*one.mutable_content())});
    }
    return inspector_.count(bytes, 0, limits::kAttachmentBytes, "bytes together", attachments);
  }

  bool take_queries(const payload::PlanRequest& from, PlanRequest& out) {
    const auto size = static_cast<std::size_t>(from.queries_size());
    if (!inspector_.count(size, 0, limits::kRobots, "", PayloadPath("queries"))) return false;
    out.queries.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
      const PayloadPath at("queries", i);
      const payload::Query& one = from.queries(static_cast<int>(i));
      PlanRequest::Query& query = out.queries[i];
      query.robot = one.robot();
      if (!inspector_.name(query.robot, PayloadPath(at, "robot")) ||
          (one.has_start() && !take(one.start(), PayloadPath(at, "start"), query.start)) ||
          (one.has_goal() && !take(one.goal(), PayloadPath(at, "goal"), query.goal))) {
        return false;
      }
    }
    return true;
  }

  // Of a robot that is not known here.
  bool take(const payload::Numbers& from, const PayloadPath& at,
            std::optional<Configuration>& out) {
    const auto size = static_cast<std::size_t>(from.value_size());
    if (!inspector_.count(size, 1, limits::kLinks, "numbers", at) ||
        !inspector_.numbers(from.value(), size, kConfigurationRange, at)) {
      return false;
    }
    out = take_numbers(from.value());
    return true;
  }

  bool take_solvers(const payload::PlanRequest& from, PlanRequest& out) {
    out.solvers.assign(from.solvers().begin(), from.solvers().end());
    if (!inspector_.count(out.solvers.size(), 0, limits::kSolvers, "names",
                          PayloadPath("solvers"))) {
      return false;
    }
    for (std::size_t i = 0; i < out.solvers.size(); ++i) {
      const PayloadPath at("solvers", i);
      if (!inspector_.name(out.solvers[i], at, limits::kSolverNameBytes)) return false;
    }
    return true;
  }

  Inspector inspector_;
};

}  // namespace

Bytes encode_request(const PlanRequest& request) {
  const auto& [id, scene_text, attachments, scene_name, queries, method, seed, solvers, deadline,
               priority] = request;
  payload::PlanRequest out;
  out.set_id(id);
  out.set_scene_text(scene_text);
  for (const auto& attachment : attachments) put(attachment, *out.add_attachments());
  out.set_scene_name(scene_name);
  for (const auto& query : queries) put(query, *out.add_queries());
  out.set_method(method);
  out.set_seed(seed);
  for (const std::string& solver : solvers) out.add_solvers(solver);
  out.set_deadline(deadline);
  out.set_priority(priority);
  return serialize_payload(out);
}

tl::expected<PlanRequest, std::string> decode_request(BytesView bytes) {
  payload::PlanRequest message;
  const ScanLimits limits{limits::kRequestBytes, limits::kRequestParts};
  if (auto fault = parse_payload(bytes, "a request", limits, message)) {
    return tl::unexpected(std::move(*fault));
  }
  PlanRequest out;
  RequestDecoder decoder;
  if (!decoder.take(message, out)) return tl::unexpected(*decoder.fault());
  return out;
}

RequestHash request_hash(const PlanRequest& request) {
  return hash_of(encode_request(request));
}

}  // namespace accord
