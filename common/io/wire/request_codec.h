#pragma once
#include <string>
#include <tl/expected.hpp>

#include "common/io/wire/bytes.h"
#include "common/io/wire/scene_hash.h"
#include "common/model/plan_request.h"
namespace accord {
inline constexpr std::string_view kRequestIdRule = "expected 1 to 128 letters";
inline bool is_request_id(const std::string& id) { return !id.empty() && id.size() <= 128; }
inline Bytes encode_request(const PlanRequest& r) {
  std::string s = r.id + "\n" + r.method + "\n" + std::to_string(r.seed) + "\n" +
                  std::to_string(r.deadline) + "\n" + std::to_string(r.priority) + "\n" + r.scene_text;
  Bytes b;
  for (char c : s) b.push_back(static_cast<Bytes::value_type>(c));
  return b;
}
inline tl::expected<PlanRequest, std::string> decode_request(BytesView b) {
  PlanRequest r;
  std::string s(b.begin(), b.end());
  auto next = [&] {
    auto i = s.find('\n');
    std::string l = s.substr(0, i);
    s = s.substr(i + 1);
    return l;
  };
  r.id = next();
  r.method = next();
  r.seed = std::stoull(next());
  r.deadline = std::stod(next());
  r.priority = std::stoi(next());
  r.scene_text = s;
  return r;
}
inline SceneHash request_hash(const PlanRequest& r) { return hash_of(encode_request(r)); }
}  // namespace accord
