// Scene files (docs/formats.md): from text to an immutable Scene, or everything that is wrong with
// it, each fault with its file, line and key, so that a person can fix all of it in one go.
//
// Made for hostile input: time and memory are bounded by limits.h whatever the files hold. Nothing
// throws but std::bad_alloc. Thread safe.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "common/io/diagnostic.h"
#include "common/io/file_source.h"
#include "common/model/scene.h"

namespace accord {

struct SceneResult {
  std::shared_ptr<const Scene> scene;  // null where there is a fault
  std::vector<Diagnostic> faults;      // by file and line
};

// A scene that is returned has passed all checks of the format: its shapes are sound, its robots'
// starts and goals keep limits, bounds, clearance and each other's room, with kQueryMargin to
// spare.
SceneResult load_scene(const std::filesystem::path& path);

// As load_scene(), from text that came some other way. `file` stands in messages. Files that the
// scene names are looked for in `folder` of `files`; with an empty one it may name none. `name` is
// what the scene is called where its text does not say; empty: as `file` is, without its ending.
// Where that cannot be a name either, it is called "scene".
SceneResult parse_scene(std::string_view text, const std::string& file,
                        const std::filesystem::path& folder,
                        const FileSource& files = file_system(), const std::string& name = "");

}  // namespace accord
