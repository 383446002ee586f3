// The scenes that a worker has at hand, ready to be worked in, and the solving of jobs in them.
// Thread safe.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "common/io/wire/scene_hash.h"
#include "common/planning/levels.h"
#include "common/transport/messages.h"
#include "worker/service/task_desk.h"

namespace accord {

class SceneShelf {
 public:
  SceneShelf();
  ~SceneShelf();

  // Makes a scene ready from its canonical bytes; a sentence says why not.
  tl::expected<void, std::string> add(const SceneHash& hash, BytesView bytes);
  void remove(const SceneHash& hash);

  struct Solved {
    ResultItem result;
    std::vector<TriedLevel>
        levels;  // how it went at each that was tried; none where it is not done
  };
  // Solves a job in its scene, which must be there. What comes back depends on the job alone,
  // unless `stop` becomes true.
  Solved solve(const TaskDesk::Job& job, const std::atomic<bool>& stop) const;

 private:
  struct Ready;

  std::shared_ptr<const Ready> find(const SceneHash& hash) const;

  mutable std::mutex mutex_;
  std::map<SceneHash, std::shared_ptr<const Ready>> scenes_;
};

}  // namespace accord
