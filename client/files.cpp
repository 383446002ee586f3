#include "client/files.h"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

#include "client/interrupt.h"
#include "common/io/plan_file.h"
#include "common/io/scene_file.h"

namespace accord {
namespace {

void explain(const std::vector<Diagnostic>& faults) {
  for (const Diagnostic& fault : faults) std::cerr << to_string(fault) << '\n';
}

bool cannot_write(const std::string& path, const std::string& why) {
  std::cerr << fmt::format("{}: cannot be written{}{}\n", path, why.empty() ? "" : ": ", why);
  return false;
}

// Why the text could not be written; nullopt: it was.
std::optional<std::string> write(const std::string& path, std::string_view text) {
  errno = 0;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (out) return std::nullopt;
  return std::generic_category().message(errno);
}

}  // namespace

std::shared_ptr<const Scene> load_scene_or_explain(const std::string& path) {
  SceneResult result = load_scene(path);
  explain(result.faults);
  return result.scene;
}

std::optional<Plan> load_plan_or_explain(const std::string& path) {
  PlanResult result = load_plan(path);
  explain(result.faults);
  return std::move(result.plan);
}

bool write_file_or_explain(const std::string& path, std::string_view text) {
  if (path == kStandardOutput) {
    std::cout << text;
    return true;
  }
  // A reader sees the old file or the new one, and a full disk leaves the old one. Pipes and
  // devices cannot be replaced, so they are written to.
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  const bool replace = !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
  const std::string target = replace ? path + ".unfinished" : path;
  std::optional<HeldSignals> held;  // nor does a signal leave half of it lying about
  if (replace) held.emplace();      // a pipe may wait for its reader for ever
  if (const std::optional<std::string> why = write(target, text)) {
    if (replace) std::filesystem::remove(target, error);
    return cannot_write(path, *why);
  }
  if (!replace) return true;
  std::filesystem::rename(target, path, error);
  return error ? cannot_write(path, error.message()) : true;
}

bool flush_output_or_explain() {
  errno = 0;
  std::cout.flush();
  if (std::cout) return true;
  // Where an earlier write failed, what it said is gone.
  return cannot_write("standard output", errno == 0 ? "" : std::generic_category().message(errno));
}

}  // namespace accord
