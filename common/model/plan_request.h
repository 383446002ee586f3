// What a fleet manager asks for: a plan for a scene. A plain value; what it may hold is checked by
// whoever takes it in (common/io/request_scene.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/model/configuration.h"

namespace accord {

struct PlanRequest {
  // A file that the scene names, by the name that it uses for it.
  struct Attachment {
    std::string name;
    std::string content;

    friend bool operator==(const Attachment&, const Attachment&) = default;
  };
  // Another start or goal than the scene's, for one of its robots.
  struct Query {
    std::string robot;
    std::optional<Configuration> start;
    std::optional<Configuration> goal;

    friend bool operator==(const Query&, const Query&) = default;
  };

  // Chosen by who asks. Two requests of one id are one request.
  std::string id;
  // The scene: a scene file's text and the files that it names, or else the name of one that the
  // coordinator has in store. Beside a text, the name is what the scene is called where the text
  // does not say.
  std::string scene_text;
  std::vector<Attachment> attachments;
  std::string scene_name;
  std::vector<Query> queries;

  std::string method = "arc";
  std::uint64_t seed = 1;
  std::vector<std::string> solvers;  // the hierarchy, in order; empty: the default one
  double deadline = 0;               // s, from when it is accepted; 0: none
  std::int32_t priority = 0;         // the higher, the sooner its planning is begun

  friend bool operator==(const PlanRequest&, const PlanRequest&) = default;
};

}  // namespace accord
