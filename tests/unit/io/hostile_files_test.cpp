// Whatever files hold, they are read or refused: no crash, no hang, no memory without bound.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include "common/io/mesh.h"
#include "common/io/movingai_map.h"
#include "common/io/pgm.h"
#include "common/io/plan_file.h"
#include "common/io/scene_file.h"
#include "common/io/urdf.h"

namespace accord {
namespace {

const std::string kScenes = ACCORD_SOURCE_DIR "/scenes/";

std::string read(const std::string& name) {
  std::ifstream stream(kScenes + name, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_FALSE(text.str().empty()) << name;
  return text.str();
}

// Does to text what bad disks, bad editors and bad people do.
class Vandal {
 public:
  explicit Vandal(unsigned seed) : random_(seed) {}

  std::string damage(std::string text) {
    const std::size_t times = 1 + below(4);
    for (std::size_t i = 0; i < times && !text.empty(); ++i) one(text);
    return text;
  }

 private:
  std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

  void one(std::string& text) {
    static constexpr std::array<std::string_view, 16> kWords = {
        "-1", "0",  "1e308", "-1e-308", ".nan", "[",         "]", "{",
        "}",  ": ", "\n",    "\"",      "<",    "999999999", "~", "\0"};
    const std::size_t at = below(text.size());
    const std::size_t length = std::min(1 + below(12), text.size() - at);
    switch (below(5)) {
      case 0:
        text[at] = static_cast<char>(text[at] ^ static_cast<char>(1U << below(8)));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(below(text.size()), text.substr(at, length * 4));
        break;
      case 3:
        text.insert(at, kWords[below(kWords.size())]);
        break;
      default:
        text.replace(at, 1, std::to_string(below(10)));
    }
  }

  std::mt19937 random_;
};

class DamagedScene : public testing::TestWithParam<std::string> {};

TEST_P(DamagedScene, IsReadOrRefused) {
  const std::string sound = read(GetParam());
  for (unsigned seed = 0; seed < 150; ++seed) {
    const SceneResult result = parse_scene(Vandal(seed).damage(sound), "damaged.yaml", kScenes);
    ASSERT_EQ(result.scene != nullptr, result.faults.empty()) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(All, DamagedScene,
                         testing::Values("carts-6.yaml", "mixed-cell.yaml", "mixed-floor.yaml",
                                         "depot-map.yaml", "rack-drones.yaml", "drones-12.yaml",
                                         "high-manipulator-2.yaml"),
                         [](const auto& param_info) {
                           std::string name =
                               param_info.param.substr(0, param_info.param.size() - 5);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(DamagedUrdf, IsReadOrRefused) {
  const std::string sound = read("panda.urdf");
  for (unsigned seed = 0; seed < 400; ++seed) {
    MeshStore meshes;
    Faults faults("damaged.urdf");
    const bool is_read =
        parse_urdf(Vandal(seed).damage(sound), "damaged.urdf", meshes, faults).has_value();
    ASSERT_EQ(is_read, faults.count() == 0) << "seed " << seed;
  }
}

TEST(DamagedMesh, IsReadOrRefused) {
  const Blame nobody_cares = [](std::string_view) {};
  const std::string sound = read("meshes/rack.obj");
  for (unsigned seed = 0; seed < 400; ++seed) {
    const std::string damaged = Vandal(seed).damage(sound);
    Faults faults("damaged");
    const auto obj = parse_obj(damaged, "damaged", faults);
    ASSERT_EQ(obj.has_value(), faults.count() == 0) << "seed " << seed;
    if (obj) weld(*obj, Vec3(1, 1, 1));
    parse_stl(damaged, "damaged", nobody_cares, faults);
  }
}

TEST(DamagedMap, IsReadOrRefused) {
  const std::string map = read("maps/depot.map");
  const std::string pgm = read("maps/floor.pgm");
  for (unsigned seed = 0; seed < 400; ++seed) {
    Faults faults("damaged");
    const bool map_read =
        parse_movingai_map(Vandal(seed).damage(map), "damaged", faults).has_value();
    ASSERT_EQ(map_read, faults.count() == 0) << "seed " << seed;
    faults.take();
    std::size_t blamed = 0;
    const Blame blame = [&](std::string_view) { ++blamed; };
    const bool pgm_read = parse_pgm(Vandal(seed).damage(pgm), "damaged", blame, faults).has_value();
    ASSERT_EQ(pgm_read, faults.count() + blamed == 0) << "seed " << seed;
  }
}

TEST(DamagedPlan, IsReadOrRefused) {
  Plan plan;
  plan.status = PlanStatus::kSolved;
  Trajectory path(2);
  for (int i = 0; i < 20; ++i) path.append(i, Configuration{0.1 * i, -0.3 * i});
  plan.robots = {{"a", path, {{0, 19, {"a"}, "prm"}}}};
  compute_costs(plan);
  const std::string sound = to_json(plan);
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const PlanResult result = parse_plan(Vandal(seed).damage(sound), "damaged.json");
    ASSERT_EQ(result.plan.has_value(), result.faults.empty()) << "seed " << seed;
  }
}

// Texts that are small to write down and dear to naive readers.
struct Bomb {
  std::string name;
  std::string text;
};

// What CTest calls the bomb; GoogleTest would print its bytes, addresses among them.
void PrintTo(const Bomb& bomb, std::ostream* out) {
  *out << bomb.name;
}

std::string repeated(std::string_view part, std::size_t times) {
  std::string out;
  for (std::size_t i = 0; i < times; ++i) out += part;
  return out;
}

std::vector<Bomb> bombs() {
  constexpr std::size_t kMany = 300'000;
  const std::string head = "accord: scene/1\n";
  return {{"open_lists", repeated("[", 10 * kMany)},
          {"open_maps", repeated("{", 10 * kMany)},
          {"nested_lists", repeated("- ", kMany)},
          {"nested_keys", repeated("? ", kMany)},
          {"aliases", "a: &a [x]\nb: [" + repeated("*a, ", kMany) + "]"},
          {"keys", head + repeated("a: 1\n", kMany)},
          {"faults", head + "models: {}\nrobots: [" + repeated("{}, ", 9'000) + "]"},
          {"empty_obstacles", head + "environment: {obstacles: [" + repeated("{}, ", kMany) + "]}"},
          {"documents", repeated("---\n", kMany)},
          {"one_long_word", head + "name: " + std::string(3'000'000, 'x')},
          {"line_feeds", repeated("\n", 10 * kMany)}};
}

class SceneBomb : public testing::TestWithParam<Bomb> {};

TEST_P(SceneBomb, IsRefusedQuickly) {
  const auto begin = std::chrono::steady_clock::now();
  const SceneResult result = parse_scene(GetParam().text, "bomb.yaml", "");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(result.scene, nullptr);
  EXPECT_FALSE(result.faults.empty());
  EXPECT_LT(result.faults.size(), 250U);
  EXPECT_LT(took.count(), 60) << "a hang, even on a slow machine with sanitizers";
}

INSTANTIATE_TEST_SUITE_P(All, SceneBomb, testing::ValuesIn(bombs()),
                         [](const auto& param_info) { return param_info.param.name; });

TEST(HostileUrdf, WithCountlessAttributesIsRefused) {
  MeshStore meshes;
  Faults faults("u");
  std::string attributes;
  for (int i = 0; i < 200'000; ++i) attributes += " a" + std::to_string(i) + "=''";
  EXPECT_FALSE(parse_urdf("<robot\n" + attributes + "/>", "u", meshes, faults));
  EXPECT_EQ(to_string(faults.take().at(0)), "u:2: more than 20000 attributes");
  EXPECT_FALSE(parse_urdf(repeated("<robot>", 100'000), "u", meshes, faults));
  EXPECT_FALSE(
      parse_urdf("<!DOCTYPE r [<!ENTITY a \"&a;&a;\">]><robot name='&a;'/>", "u", meshes, faults));
}

TEST(TwoThousandRobots, AreCheckedAgainstEachOtherInNoTime) {
  std::string text =
      "accord: scene/1\nenvironment: {bounds: [[-1, -1], [100, 100]]}\n"
      "models: {m: {disk: 0.3, speed: 1}}\nrobots:\n";
  for (int i = 0; i < 2000; ++i) {
    const std::string place = std::to_string(i % 45 * 2) + ", " + std::to_string(i / 45 * 2);
    text += "  - {name: r" + std::to_string(i) + ", model: m, start: [" + place + "], goal: [" +
            place + "]}\n";
  }
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_NE(parse_scene(text, "s", "").scene, nullptr);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(took.count(), 20);
}

}  // namespace
}  // namespace accord
