// Scenes to bytes and back: complete, meshes included, so that who receives one needs no files.
//
// Canonical: one scene, one sequence of bytes, on every machine; scene_hash.h names it by them.
// Which robots share a model, and which shapes a mesh, is part of the scene: it decides what they
// share when they are planned.
// Thread safe. Nothing throws but std::bad_alloc.
#pragma once

#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "common/io/wire/bytes.h"
#include "common/model/scene.h"

namespace accord {

// Requires: the scene passed io's checks.
Bytes encode_scene(const Scene& scene);

// The scene, bit for bit, or a sentence that says which field is wrong and what was expected, as in
// "robots[4].start: expected 3 numbers, not 2". Takes any bytes: what a scene file is checked for
// is checked here, within the same limits, so that a CollisionWorld can be built; but not whether
// starts and goals are free, which costs as much as building one. Memory stays within some 400 MB,
// and below a small multiple of what is used by as many sound bytes.
tl::expected<std::shared_ptr<const Scene>, std::string> decode_scene(BytesView bytes);

}  // namespace accord
