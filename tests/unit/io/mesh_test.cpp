// The same surface from each mesh format; what counts as closed.
#include "common/io/mesh.h"

#include <gtest/gtest.h>

#include <bit>
#include <filesystem>

#include "common/io/triangle_soup.h"

namespace accord {
namespace {

constexpr std::string_view kTetrahedron =
    "# a corner of a cube\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\n"
    "f 1//1 3//1 2//1\nf 1 2 4\nf 2 3 4\nf -4 -1 -2\n";

TriangleSoup soup_of(std::string_view obj) {
  Faults faults("o");
  const auto soup = parse_obj(obj, "o", faults);
  for (const Diagnostic& fault : faults.take()) ADD_FAILURE() << to_string(fault);
  return soup.value_or(TriangleSoup{});
}

std::string binary_stl(const TriangleSoup& soup) {
  std::string out(80, ' ');
  out.replace(0, 5, "solid");  // some writers do
  const auto put = [&](std::uint32_t value) {
    for (unsigned i = 0; i < 4; ++i) out += static_cast<char>(value >> (8 * i) & 0xFFU);
  };
  put(static_cast<std::uint32_t>(soup.size()));
  for (const auto& triangle : soup) {
    for (int i = 0; i < 3; ++i) put(0);
    for (const Vec3& corner : triangle) {
      for (const double value : corner)
        put(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
    }
    out += std::string(2, '\0');
  }
  return out;
}

std::string text_stl(const TriangleSoup& soup) {
  std::string out = "solid t\n";
  for (const auto& triangle : soup) {
    out += "facet normal 0 0 0\n outer loop\n";
    for (const Vec3& corner : triangle) {
      out += "  vertex";
      for (const double value : corner) out += " " + std::to_string(value);
      out += "\n";
    }
    out += " endloop\nendfacet\n";
  }
  return out + "endsolid t\n";
}

bool same(const TriangleMesh& a, const TriangleMesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles && a.closed == b.closed;
}

TEST(Mesh, IsTheSameFromEveryFormat) {
  const TriangleSoup soup = soup_of(kTetrahedron);
  const TriangleMesh mesh = weld(soup, Vec3(1, 1, 1));
  EXPECT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.triangles.size(), 4U);
  EXPECT_TRUE(mesh.closed);
  Faults faults("s");
  const auto text = parse_stl(text_stl(soup), "s", faults);
  const auto binary = parse_stl(binary_stl(soup), "s", faults);
  ASSERT_TRUE(text && binary);
  EXPECT_TRUE(same(weld(*text, Vec3(1, 1, 1)), mesh));
  EXPECT_TRUE(same(weld(*binary, Vec3(1, 1, 1)), mesh));
}

TEST(Mesh, IsOpenWithATriangleMissingOrTurned) {
  TriangleSoup soup = soup_of(kTetrahedron);
  std::swap(soup[0][0], soup[0][1]);
  EXPECT_FALSE(weld(soup, Vec3(1, 1, 1)).closed);
  soup.erase(soup.begin());
  EXPECT_FALSE(weld(soup, Vec3(1, 1, 1)).closed);
}

TEST(Mesh, DropsSliversButLetsThemCloseGaps) {
  // The edge from 1 to 2 is split on one side only; a triangle without area mends that.
  const TriangleMesh mesh = weld(soup_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0.5 0 0\n"
                                         "f 1 3 2\nf 1 5 4\nf 5 2 4\nf 2 3 4\nf 3 1 4\nf 1 2 5\n"),
                                 Vec3(1, 1, 1));
  EXPECT_TRUE(mesh.closed);
  EXPECT_EQ(mesh.triangles.size(), 5U);
}

TEST(Mesh, CutsConvexFacesIntoTriangles) {
  EXPECT_EQ(soup_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n").size(), 2U);
}

TEST(Mesh, RefusesFacesThatAreNotConvex) {
  Faults faults("o");
  EXPECT_FALSE(parse_obj("v 0 0 0\nv 2 0 0\nv 0.5 0.5 0\nv 0 2 0\nf 2 3 4 1\n", "o", faults) &&
               parse_obj("v 0 0 0\nv 2 0 0\nv 0.5 0.5 0\nv 0 2 0\nf 1 2 3 4\n", "o", faults));
}

TEST(Mesh, ScalesEachAxis) {
  const TriangleMesh mesh = weld(soup_of(kTetrahedron), Vec3(2, 3, 4));
  EXPECT_EQ(mesh.vertices.back(), Vec3(2, 0, 0));
  EXPECT_EQ(mesh.vertices[1], Vec3(0, 0, 4));
}

TEST(MeshStore, SharesWhatItHasReadOnce) {
  MeshStore store;
  Faults faults("s");
  const std::filesystem::path path = ACCORD_SOURCE_DIR "/scenes/meshes/rack.obj";
  const Blame nobody = [](std::string_view text) { FAIL() << text; };
  const auto one = store.load(path, Vec3(1, 1, 1), nobody, faults);
  ASSERT_NE(one, nullptr);
  EXPECT_TRUE(one->closed);
  EXPECT_EQ(store.load(path, Vec3(1, 1, 1), nobody, faults), one);
  EXPECT_NE(store.load(path, Vec3(2, 2, 2), nobody, faults), one);
}

}  // namespace
}  // namespace accord
