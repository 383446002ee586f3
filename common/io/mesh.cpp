#include "common/io/mesh.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "common/io/files.h"
#include "common/io/limits.h"
#include "common/io/words.h"

namespace accord {
namespace {

bool before(const Vec3& a, const Vec3& b) {
  return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
}

// Sorted and without repeats; index_of[i] is where points[i] went.
std::vector<Vec3> unique_points(const std::vector<Vec3>& points,
                                std::vector<std::uint32_t>& index_of) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return before(points[a], points[b]) || (!before(points[b], points[a]) && a < b);
  });
  std::vector<Vec3> out;
  index_of.resize(points.size());
  for (const std::uint32_t i : order) {
    if (out.empty() || out.back() != points[i]) out.push_back(points[i]);
    index_of[i] = static_cast<std::uint32_t>(out.size() - 1);
  }
  return out;
}

struct Edge {
  std::uint32_t low;
  std::uint32_t high;
  int direction;
};

bool is_closed(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k];
      const std::uint32_t b = triangle[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  }
  const auto by_ends = [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  };
  std::ranges::sort(edges, by_ends);
  for (std::size_t i = 0; i < edges.size();) {
    int balance = 0;
    std::size_t j = i;
    for (; j < edges.size() && !by_ends(edges[i], edges[j]); ++j) balance += edges[j].direction;
    if (balance != 0) return false;
    i = j;
  }
  return !triangles.empty();
}

std::optional<TriangleSoup> parse(const std::filesystem::path& path, const FileSource& files,
                                  const Blame& blame, Faults& faults) {
  const std::string extension = extension_of(path);
  if (extension != ".stl" && extension != ".obj") {
    blame("expected a mesh that ends in .stl or .obj, not " + path_in_quotes(path));
    return std::nullopt;
  }
  const auto bytes = files.read(path, limits::kMeshBytes);
  if (!bytes) {
    blame(bytes.error());
    return std::nullopt;
  }
  return extension == ".stl" ? parse_stl(*bytes, path.string(), blame, faults)
                             : parse_obj(*bytes, path.string(), faults);
}

// Whether a mesh can be worked with; says why not. The size first: what is far too large or too
// small has no areas that could be told.
bool is_sound(const TriangleMesh& mesh, const std::string& name, const MeshBlame& blame) {
  double reach = 0;
  Vec3 low = mesh.vertices.empty() ? Vec3::Zero() : mesh.vertices.front();
  Vec3 high = low;
  for (const Vec3& vertex : mesh.vertices) {
    reach = std::max(reach, vertex.cwiseAbs().maxCoeff());
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  if (reach > limits::kCoordinate) {
    blame.scale(name + " has coordinates of up to " + in_words(reach) +
                " m at this scale; expected at most " + in_words(limits::kCoordinate) + " m");
    return false;
  }
  const double size = (high - low).maxCoeff();
  if (!mesh.vertices.empty() && size < limits::kMinSize) {
    blame.scale(name + " measures no more than " + in_words(size) +
                " m at this scale; expected at least " + in_words(limits::kMinSize) + " m");
    return false;
  }
  if (mesh.triangles.empty()) blame.file(name + " has no triangle with an area");
  return !mesh.triangles.empty();
}

}  // namespace

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double kThin = 1e-10;  // height against length
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() > kThin * longest;
}

TriangleMesh weld(const TriangleSoup& soup, const Vec3& scale) {
  std::vector<Vec3> corners;
  corners.reserve(3 * soup.size());
  for (const auto& triangle : soup) {
    // Adding zero turns -0 into 0, which is the same place.
    for (const Vec3& corner : triangle) {
      corners.emplace_back((corner.cwiseProduct(scale).array() + 0.0).matrix());
    }
  }
  TriangleMesh mesh;
  std::vector<std::uint32_t> index_of;
  mesh.vertices = unique_points(corners, index_of);
  for (std::size_t i = 0; i < index_of.size(); i += 3) {
    const std::array<std::uint32_t, 3> triangle{index_of[i], index_of[i + 1], index_of[i + 2]};
    const bool distinct =
        triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0];
    if (distinct) mesh.triangles.push_back(triangle);
  }
  // Slivers close gaps, so they count here, but not as parts of the surface: their neighbours'
  // edges hold all of their points.
  mesh.closed = is_closed(mesh.triangles);
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return !has_area(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
  });
  return mesh;
}

std::shared_ptr<const TriangleMesh> MeshStore::load(const std::filesystem::path& path,
                                                    const Vec3& scale, const MeshBlame& blame,
                                                    Faults& faults) {
  const auto [found, is_new] =
      meshes_.try_emplace({path.string(), {scale.x(), scale.y(), scale.z()}});
  if (!is_new) return found->second;
  const auto soup = parse(path, files_, blame.file, faults);
  if (!soup) return nullptr;
  auto mesh = std::make_shared<TriangleMesh>(weld(*soup, scale));
  if (!is_sound(*mesh, path_in_quotes(path), blame)) return nullptr;
  found->second = std::move(mesh);
  return found->second;
}

}  // namespace accord
