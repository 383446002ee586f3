// Tasks that nobody could solve, to files and back, so that they can be looked at and tried again
// elsewhere (`accord replay`): the scene, the solvers and the subproblem, as they were sent, and
// why they were kept. Evolves as all payloads do (idl/accord.proto).
//
// Canonical: one value, one sequence of bytes. Thread safe. Nothing throws but std::bad_alloc.
#pragma once

#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "common/io/wire/bytes.h"
#include "common/model/scene.h"
#include "common/planning/subproblem.h"

namespace accord {

// As bytes, as whoever gives out tasks has it.
struct TaskRecord {
  Bytes scene;       // encode_scene()
  Bytes hierarchy;   // encode_hierarchy()
  Bytes subproblem;  // encode_subproblem(), of that scene
  std::string why;   // for people; any bytes: what could not be printed is kept as '?', and the
                     // first limits::kWhyBytes only
};

// As values.
struct RecordedTask {
  std::shared_ptr<const Scene> scene;
  std::vector<std::string> solvers;  // whether they exist is for make_solver() to say
  Subproblem subproblem;
  std::string why;  // UTF-8 without control characters but line feeds and the like
};

Bytes encode_task_record(const TaskRecord& record);

// The task, or a sentence that says what is wrong, as in "subproblem: tasks[0].goal: expected 3
// numbers, not 2". Takes any bytes: what comes back can be given to every solver.
tl::expected<RecordedTask, std::string> decode_task_record(BytesView bytes);

}  // namespace accord
