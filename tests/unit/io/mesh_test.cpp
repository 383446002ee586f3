// The same surface from each mesh format; what counts as closed.
#include "common/io/mesh.h"

#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "common/io/files.h"
#include "common/io/limits.h"
#include "common/io/triangle_soup.h"

namespace accord {
namespace {

constexpr std::string_view kTetrahedron =
    "# a corner of a cube\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\n"
    "f 1//1 3//1 2//1\nf 1 2 4\nf 2 3 4\nf -4 -1 -2\n";

void nobody(std::string_view text) {
  ADD_FAILURE() << text;
}

const MeshBlame kNobody{nobody, nobody};

// What is reported of a mesh: "line text", or "file text" where no line is to blame.
template <typename Parser>
std::vector<std::string> faults_of(const Parser& parse) {
  Faults faults("m");
  std::vector<std::string> out;
  const Blame blame = [&](std::string_view text) { out.push_back("file " + std::string(text)); };
  EXPECT_FALSE(parse(blame, faults));
  for (const Diagnostic& fault : faults.take()) {
    out.push_back(std::to_string(fault.line) + " " + fault.text);
  }
  return out;
}

std::vector<std::string> faults_of_obj(std::string_view text) {
  return faults_of([&](const Blame&, Faults& faults) { return parse_obj(text, "m", faults); });
}

std::vector<std::string> faults_of_stl(std::string_view bytes) {
  return faults_of(
      [&](const Blame& blame, Faults& faults) { return parse_stl(bytes, "m", blame, faults); });
}

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
  const auto text = parse_stl(text_stl(soup), "s", nobody, faults);
  const auto binary = parse_stl(binary_stl(soup), "s", nobody, faults);
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

TEST(Obj, ReportsEveryBadLine) {
  EXPECT_EQ(faults_of_obj("v 0 0 0\nv 1 x 0\nv 0 1 0\nvertex 3\nf 1 2\nf 1 2 3\nf 1 2 9\n"),
            (std::vector<std::string>{
                "2 expected three finite coordinates after v, not \"x\"",
                "4 expected a line of an OBJ file, such as v or f, not \"vertex\"",
                "5 a face of 2 corners; expected 3 or more",
                "7 expected the number of one of the 3 vertices so far, not \"9\""}));
}

TEST(Stl, ReportsEveryBadLine) {
  EXPECT_EQ(
      faults_of_stl("solid s\nfacet\nvertex 0 0 0\nvertex 1 x 0\nvertex 0 1 0\nvertex 2 2 2\n"
                    "endfacet\nfacets\nvertex 0 0 0\nendfacet\nvertex 0 0 0\n"),
      (std::vector<std::string>{
          "4 expected three finite coordinates after vertex, not \"x\"",
          "6 a facet of more than 3 vertices", "8 expected a line of an STL file, not \"facets\"",
          "10 a facet of 1 vertices; expected 3", "11 the file ends inside a facet"}));
}

TEST(MeshFaults, AreListedUpToALimit) {
  std::string text;
  for (std::size_t i = 0; i < 10 * limits::kLineFaults; ++i) text += "word\n";
  for (const auto& list : {faults_of_obj(text), faults_of_stl("solid s\n" + text)}) {
    ASSERT_EQ(list.size(), limits::kLineFaults + 1);
    EXPECT_TRUE(list.back().ends_with("no more than 20 faults of a file are listed"));
  }
}

TEST(MeshFaults, WithoutALineNameTheFile) {
  EXPECT_EQ(faults_of_stl("binary"),
            (std::vector<std::string>{
                "file \"m\" is not an STL file: neither text that starts with \"solid\" nor binary "
                "of the size that its header says"}));
  TriangleSoup soup = soup_of(kTetrahedron);
  soup[2][1].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(faults_of_stl(binary_stl(soup)),
            (std::vector<std::string>{
                "file triangle 2 of \"m\" has the coordinate nan; expected finite ones"}));
}

TEST(MeshLimits, HoldForEveryFormat) {
  const TriangleSoup many(limits::kTriangles + 1, soup_of(kTetrahedron)[0]);
  EXPECT_EQ(faults_of_stl(binary_stl(many)),
            (std::vector<std::string>{"file \"m\" has 500001 triangles; expected at most 500000"}));
  std::string facets = "solid s\n";
  std::string faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (std::size_t i = 0; i < many.size(); ++i) {
    facets += "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\n";
    faces += "f 1 2 3\n";
  }
  EXPECT_EQ(faults_of_stl(facets),
            (std::vector<std::string>{"2000005 more than 500000 triangles"}));
  EXPECT_EQ(faults_of_obj(faces), (std::vector<std::string>{"500004 more than 500000 triangles"}));
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
  const auto one = store.load(path, Vec3(1, 1, 1), kNobody, faults);
  ASSERT_NE(one, nullptr);
  EXPECT_TRUE(one->closed);
  EXPECT_EQ(store.load(path, Vec3(1, 1, 1), kNobody, faults), one);
  EXPECT_NE(store.load(path, Vec3(2, 2, 2), kNobody, faults), one);
}

TEST(MeshStore, BlamesTheScaleForASizeThatIsFarOff) {
  MeshStore store;
  Faults faults("s");
  const std::filesystem::path path = ACCORD_SOURCE_DIR "/tests/invalid/files/tetrahedron.obj";
  std::vector<std::string> blamed;
  const MeshBlame blame{nobody, [&](std::string_view text) { blamed.emplace_back(text); }};
  EXPECT_EQ(store.load(path, Vec3(1, 1e9, 1), blame, faults), nullptr);
  EXPECT_EQ(store.load(path, Vec3(1e-9, 1e-9, 1e-9), blame, faults), nullptr);
  EXPECT_NE(store.load(path, Vec3(1e-9, 1e-5, 1e-9), blame, faults), nullptr);
  EXPECT_EQ(blamed, (std::vector<std::string>{
                        path_in_quotes(path) +
                            " has coordinates of up to 1e+09 m at this scale; expected at most "
                            "100000 m",
                        path_in_quotes(path) +
                            " measures no more than 1e-09 m at this scale; expected at least "
                            "1e-05 m"}));
  EXPECT_EQ(faults.count(), 0U);
}

}  // namespace
}  // namespace accord
