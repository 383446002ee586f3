// Resolutions to bytes and back.
//
// Canonical: one value, one sequence of bytes. Thread safe. Nothing throws but std::bad_alloc.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "common/io/wire/bytes.h"
#include "common/model/scene.h"
#include "common/planning/subproblem.h"

namespace accord {

Bytes encode_resolution(const Resolution& resolution);

// The resolution, bit for bit, or a sentence that says which field is wrong and what was expected.
// Takes any bytes: a resolution that comes back answers that subproblem in form: a path a task, of
// the robot's degrees of freedom, with increasing times, or none at all where it is not solved.
// Whether it holds is for resolution_fault() to say.
// Requires: the subproblem is of the scene.
tl::expected<Resolution, std::string> decode_resolution(BytesView bytes, const Scene& scene,
                                                        const Subproblem& subproblem);

}  // namespace accord
