#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "common/io/fields.h"
#include "common/io/limits.h"
#include "common/io/line_faults.h"
#include "common/io/line_reader.h"
#include "common/io/triangle_soup.h"
#include "common/io/words.h"

namespace accord {
namespace {

// Statements that say nothing about where the surface is.
constexpr std::array<std::string_view, 10> kDecoration = {"vn", "vt", "vp", "o",      "g",
                                                          "s",  "l",  "p",  "usemtl", "mtllib"};

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::string& file, Faults& faults)
      : lines_(text), faults_(lines_, file, faults) {}

  std::optional<TriangleSoup> parse() {
    while (!faults_.over() && lines_.next()) {
      std::string_view rest = lines_.line().substr(0, lines_.line().find('#'));
      const std::string_view word = take_word(rest);
      statement(word, rest);
    }
    if (faults_.any()) return std::nullopt;
    return std::move(soup_);
  }

 private:
  void statement(std::string_view word, std::string_view rest) {
    if (word == "v") return vertex(rest);
    if (word == "f") return face(rest);
    if (word.empty() || std::ranges::find(kDecoration, word) != kDecoration.end()) return;
    faults_.add("expected a line of an OBJ file, such as v or f, not " + in_quotes(word));
  }

  void vertex(std::string_view rest) {
    if (vertices_.size() == 3 * limits::kTriangles) {
      return faults_.give_up("more than " + std::to_string(3 * limits::kTriangles) + " vertices");
    }
    Vec3 point;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const std::string_view word = take_word(rest);
      const auto value = parse_number(word);
      if (!value || !std::isfinite(*value)) {
        faults_.add("expected three finite coordinates after v, not " + in_quotes(word));
        // A vertex all the same, so that later ones keep their numbers; no face of it is at fault.
        point.setConstant(std::numeric_limits<double>::quiet_NaN());
        break;
      }
      point[k] = *value;
    }
    vertices_.push_back(point);
  }

  void face(std::string_view rest) {
    std::vector<Vec3> corners;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
      const auto corner = corner_index(word);
      if (!corner) return;
      corners.push_back(vertices_[*corner]);
      if (corners.size() > limits::kPolygonVertices) {
        return faults_.add("a face of more than " + std::to_string(limits::kPolygonVertices) +
                           " corners");
      }
    }
    if (corners.size() < 3) {
      return faults_.add("a face of " + std::to_string(corners.size()) +
                         " corners; expected 3 or more");
    }
    fan(corners);
  }

  // "7", "7/1", "7//2", "7/1/2": the first number, from 1; negative ones count from the end.
  std::optional<std::size_t> corner_index(std::string_view word) {
    const std::string_view digits = word.substr(0, word.find('/'));
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    const auto count = static_cast<std::int64_t>(vertices_.size());
    if (index < 0) index += count + 1;
    if (error != std::errc() || end != digits.data() + digits.size() || index < 1 ||
        index > count) {
      faults_.add("expected the number of one of the " + std::to_string(count) +
                  " vertices so far, not " + in_quotes(word));
      return std::nullopt;
    }
    return static_cast<std::size_t>(index - 1);
  }

  void fan(const std::vector<Vec3>& corners) {
    Vec3 normal = Vec3::Zero();  // of the whole face
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      normal += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const Vec3 one = (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
      if (one.dot(normal) < -1e-9 * normal.squaredNorm()) {
        return faults_.add("a face that is not convex; cut it into triangles");
      }
      soup_.push_back({corners[0], corners[i], corners[i + 1]});
    }
    if (soup_.size() > limits::kTriangles) {
      faults_.give_up("more than " + std::to_string(limits::kTriangles) + " triangles");
    }
  }

  LineReader lines_;
  LineFaults faults_;
  std::vector<Vec3> vertices_;
  TriangleSoup soup_;
};

}  // namespace

std::optional<TriangleSoup> parse_obj(std::string_view text, const std::string& file,
                                      Faults& faults) {
  return ObjParser(text, file, faults).parse();
}

}  // namespace accord
