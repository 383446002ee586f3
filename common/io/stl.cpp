#include <bit>
#include <cmath>
#include <cstdint>

#include "common/io/fields.h"
#include "common/io/files.h"
#include "common/io/limits.h"
#include "common/io/line_faults.h"
#include "common/io/line_reader.h"
#include "common/io/triangle_soup.h"
#include "common/io/words.h"

namespace accord {
namespace {

constexpr std::size_t kHeader = 84;    // bytes: 80 of text, the number of triangles
constexpr std::size_t kTriangle = 50;  // bytes: normal, three corners, two bytes of attributes

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) {
    value = (value << 8U) | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

std::optional<TriangleSoup> parse_binary(std::string_view bytes, const std::string& file,
                                         const Blame& blame) {
  const std::size_t count = little_endian(bytes, kHeader - 4);
  if (count > limits::kTriangles) {
    blame(path_in_quotes(file) + " has " + std::to_string(count) + " triangles; expected at most " +
          std::to_string(limits::kTriangles));
    return std::nullopt;
  }
  TriangleSoup soup(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t at = kHeader + i * kTriangle + 12 + 4 * k;
      const double value = std::bit_cast<float>(little_endian(bytes, at));
      if (!std::isfinite(value)) {
        blame("triangle " + std::to_string(i) + " of " + path_in_quotes(file) +
              " has the coordinate " + in_words(value) + "; expected finite ones");
        return std::nullopt;
      }
      soup[i][k / 3][static_cast<Eigen::Index>(k % 3)] = value;
    }
  }
  return soup;
}

class TextParser {
 public:
  TextParser(std::string_view text, const std::string& file, Faults& faults)
      : lines_(text), faults_(lines_, file, faults) {}

  std::optional<TriangleSoup> parse() {
    while (!faults_.over() && lines_.next()) {
      std::string_view rest = lines_.line();
      const std::string_view word = take_word(rest);
      statement(word, rest);
    }
    if (!faults_.over() && corners_ != 0) faults_.add("the file ends inside a facet");
    if (faults_.any()) return std::nullopt;
    return std::move(soup_);
  }

 private:
  void statement(std::string_view word, std::string_view rest) {
    if (word == "vertex") return vertex(rest);
    if (word == "endfacet") return end_facet();
    const bool known = word.empty() || word == "solid" || word == "facet" || word == "outer" ||
                       word == "endloop" || word == "endsolid";
    if (!known) faults_.add("expected a line of an STL file, not " + in_quotes(word));
  }

  void vertex(std::string_view rest) {
    if (corners_ == 3) return faults_.add("a facet of more than 3 vertices");
    Vec3& corner = triangle_[corners_++];
    for (Eigen::Index k = 0; k < 3; ++k) {
      const std::string_view word = take_word(rest);
      const auto value = parse_number(word);
      if (!value || !std::isfinite(*value)) {
        return faults_.add("expected three finite coordinates after vertex, not " +
                           in_quotes(word));
      }
      corner[k] = *value;
    }
  }

  void end_facet() {
    if (corners_ != 3) {
      faults_.add("a facet of " + std::to_string(corners_) + " vertices; expected 3");
    }
    corners_ = 0;
    soup_.push_back(triangle_);
    if (soup_.size() > limits::kTriangles) {
      faults_.give_up("more than " + std::to_string(limits::kTriangles) + " triangles");
    }
  }

  LineReader lines_;
  LineFaults faults_;
  TriangleSoup soup_;
  std::array<Vec3, 3> triangle_ = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  std::size_t corners_ = 0;
};

}  // namespace

std::optional<TriangleSoup> parse_stl(std::string_view bytes, const std::string& file,
                                      const Blame& blame, Faults& faults) {
  // Binary files may start with "solid" too, so the size decides.
  if (bytes.size() >= kHeader) {
    const std::size_t count = little_endian(bytes, kHeader - 4);
    if (bytes.size() == kHeader + count * kTriangle) return parse_binary(bytes, file, blame);
  }
  std::string_view start = bytes.substr(0, 256);
  if (take_word(start) != "solid") {
    blame(
        path_in_quotes(file) +
        " is not an STL file: neither text that starts with \"solid\" nor binary of the size that "
        "its header says");
    return std::nullopt;
  }
  return TextParser(bytes, file, faults).parse();
}

}  // namespace accord
