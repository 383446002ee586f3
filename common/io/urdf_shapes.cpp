#include "common/io/urdf_shapes.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "common/io/files.h"
#include "common/io/words.h"

namespace accord {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> kShapes = {"box", "cylinder", "sphere", "capsule",
                                                     "mesh"};
constexpr std::string_view kPackage = "package://";

tl::expected<fs::path, std::string> resolve_mesh(std::string_view reference, const fs::path& folder,
                                                 const FileSource& files) {
  if (!reference.starts_with(kPackage)) return resolve(reference, folder);
  const std::string_view in_package = reference.substr(kPackage.size());
  const std::size_t slash = in_package.find('/');
  const std::string_view rest =
      slash == std::string_view::npos ? std::string_view() : in_package.substr(slash + 1);
  auto here = resolve(rest, folder);
  auto above = resolve(rest, (folder / "..").lexically_normal());
  if (!here || !above) return here;
  if (files.is_file(*here)) return here;
  if (files.is_file(*above)) return above;
  return tl::unexpected("cannot find " + in_quotes(reference) + "; looked for " + in_quotes(rest) +
                        " in this file's folder and in the one above");
}

std::optional<Shape> read_mesh(const XmlElement& element, const fs::path& folder, MeshStore& meshes,
                               Faults& faults) {
  constexpr Range kScale{1e-9, 1e9, ""};
  const auto scale = element.has("scale") ? element.vector("scale", kScale) : Vec3(1, 1, 1);
  const auto reference = element.name("filename");
  if (!reference || !scale) return std::nullopt;
  const auto path = resolve_mesh(*reference, folder, meshes.files());
  if (!path) {
    element.fault(path.error());
    return std::nullopt;
  }
  const MeshBlame blame{.file = [&](auto text) { element.fault(text); },
                        .scale =
                            [&](auto text) {
                              if (element.has("scale")) return element.fault("scale", text);
                              element.fault(text);
                            }};
  auto surface = meshes.load(*path, *scale, blame, faults);
  if (!surface) return std::nullopt;
  return Mesh{std::move(surface)};
}

std::optional<Shape> read_one(const XmlElement& element, std::string_view kind,
                              const fs::path& folder, MeshStore& meshes, Faults& faults) {
  if (kind == "mesh") return read_mesh(element, folder, meshes, faults);
  if (kind == "box") {
    const auto size = element.vector("size", kSizeRange);
    return size ? std::optional<Shape>(Box{*size}) : std::nullopt;
  }
  const auto radius = element.number("radius", kSizeRange);
  if (kind == "sphere") return radius ? std::optional<Shape>(Sphere{*radius}) : std::nullopt;
  const auto length = element.number("length", kSizeRange);
  if (!radius || !length) return std::nullopt;
  if (kind == "capsule") return Capsule{*radius, *length};
  return Cylinder{*radius, *length};
}

}  // namespace

std::optional<Shape> read_urdf_shape(const XmlElement& geometry, const fs::path& folder,
                                     MeshStore& meshes, Faults& faults) {
  const auto* first = geometry.raw().FirstChildElement();
  if (first == nullptr || first->NextSiblingElement() != nullptr) {
    geometry.fault("expected one shape: " + alternatives(kShapes));
    return std::nullopt;
  }
  const std::string_view kind(first->Name());
  if (std::ranges::find(kShapes, kind) == kShapes.end()) {
    geometry.fault("unknown shape " + in_quotes(kind) + "; expected " + alternatives(kShapes));
    return std::nullopt;
  }
  const XmlElement element = geometry.with_key(*first, geometry.key() + "." + std::string(kind));
  return read_one(element, kind, folder, meshes, faults);
}

}  // namespace accord
