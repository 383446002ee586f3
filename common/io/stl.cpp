#include <bit>
#include <cmath>
#include <cstdint>

#include "common/io/fields.h"
#include "common/io/limits.h"
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

bool too_many(std::size_t triangles, int line, const std::string& file, Faults& faults) {
  if (triangles <= limits::kTriangles) return false;
  faults.add(file, line, "", "more than " + std::to_string(limits::kTriangles) + " triangles");
  return true;
}

std::optional<TriangleSoup> parse_binary(std::string_view bytes, const std::string& file,
                                         Faults& faults) {
  const std::size_t count = little_endian(bytes, kHeader - 4);
  if (too_many(count, 0, file, faults)) return std::nullopt;
  TriangleSoup soup(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t at = kHeader + i * kTriangle + 12 + 4 * k;
      const double value = std::bit_cast<float>(little_endian(bytes, at));
      if (!std::isfinite(value)) {
        faults.add(file, 0, "triangle " + std::to_string(i),
                   "expected finite coordinates, not " + in_words(value));
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
      : lines_(text), file_(file), faults_(faults) {}

  std::optional<TriangleSoup> parse() {
    while (lines_.next()) {
      std::string_view rest = lines_.line();
      const std::string_view word = take_word(rest);
      if (!statement(word, rest)) return std::nullopt;
    }
    if (corners_ != 0) {
      fault("the file ends inside a facet");
      return std::nullopt;
    }
    return std::move(soup_);
  }

 private:
  bool fault(std::string_view text) {
    faults_.add(file_, lines_.number(), "", text);
    return false;
  }

  bool statement(std::string_view word, std::string_view rest) {
    if (word == "vertex") return vertex(rest);
    if (word == "endfacet") {
      if (corners_ != 3) {
        return fault("a facet of " + std::to_string(corners_) + " vertices; expected 3");
      }
      soup_.push_back(triangle_);
      corners_ = 0;
      return !too_many(soup_.size(), lines_.number(), file_, faults_);
    }
    const bool known = word.empty() || word == "solid" || word == "facet" || word == "outer" ||
                       word == "endloop" || word == "endsolid";
    return known || fault("expected a line of an STL file, not " + in_quotes(word));
  }

  bool vertex(std::string_view rest) {
    if (corners_ == 3) return fault("a facet of more than 3 vertices");
    for (Eigen::Index k = 0; k < 3; ++k) {
      const std::string_view word = take_word(rest);
      const auto value = parse_number(word);
      if (!value || !std::isfinite(*value)) {
        return fault("expected three finite coordinates after vertex, not " + in_quotes(word));
      }
      triangle_[corners_][k] = *value;
    }
    ++corners_;
    return true;
  }

  LineReader lines_;
  const std::string& file_;
  Faults& faults_;
  TriangleSoup soup_;
  std::array<Vec3, 3> triangle_;
  std::size_t corners_ = 0;
};

}  // namespace

std::optional<TriangleSoup> parse_stl(std::string_view bytes, const std::string& file,
                                      Faults& faults) {
  // Binary files may start with "solid" too, so the size decides.
  if (bytes.size() >= kHeader) {
    const std::size_t count = little_endian(bytes, kHeader - 4);
    if (bytes.size() == kHeader + count * kTriangle) return parse_binary(bytes, file, faults);
  }
  std::string_view start = bytes.substr(0, 256);
  if (take_word(start) != "solid") {
    faults.add(file, 0, "",
               "not an STL file: neither text that starts with \"solid\" nor binary of the size "
               "that its header says");
    return std::nullopt;
  }
  return TextParser(bytes, file, faults).parse();
}

}  // namespace accord
