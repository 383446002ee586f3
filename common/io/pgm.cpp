#include "common/io/pgm.h"

#include <charconv>

#include "common/io/files.h"
#include "common/io/limits.h"
#include "common/io/words.h"

namespace accord {
namespace {

class PgmParser {
 public:
  PgmParser(std::string_view bytes, const std::string& file, const Blame& blame, Faults& faults)
      : rest_(bytes), file_(file), blame_(blame), faults_(faults) {}

  std::optional<Graymap> parse() {
    const std::string_view magic = rest_.substr(0, 2);
    if (magic != "P2" && magic != "P5") {
      return fail("expected a graymap that starts with P2 or P5, not " + in_quotes(magic));
    }
    rest_.remove_prefix(2);
    const auto width = number("a width", 1, limits::kMapSide);
    const auto height = width ? number("a height", 1, limits::kMapSide) : std::nullopt;
    const auto max_value = height ? number("the value of white", 1, 65535) : std::nullopt;
    if (!max_value) return std::nullopt;
    if (*width * *height > limits::kMapCells) {
      return fail(std::to_string(*width) + " x " + std::to_string(*height) +
                  " cells; expected at most " + std::to_string(limits::kMapCells));
    }
    Graymap map{*width, *height, static_cast<unsigned>(*max_value), {}};
    if (!(magic == "P2" ? read_text(map) : read_binary(map))) return std::nullopt;
    return map;
  }

 private:
  std::nullopt_t fail(std::string_view text) {
    faults_.add(file_, line_, "", text);
    return std::nullopt;
  }

  void skip_blanks_and_comments() {
    bool comment = false;
    while (!rest_.empty()) {
      const char c = rest_.front();
      if (c == '#') comment = true;
      if (c == '\n') comment = false;
      const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
      if (!blank && !comment) return;
      if (c == '\n') ++line_;
      rest_.remove_prefix(1);
    }
  }

  std::optional<std::size_t> number(std::string_view what, std::size_t min, std::size_t max) {
    skip_blanks_and_comments();
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc() || value < min || value > max) {
      const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r\n"));
      return fail("expected " + std::string(what) + " from " + std::to_string(min) + " to " +
                  std::to_string(max) + ", not " + in_quotes(word));
    }
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  bool read_text(Graymap& map) {
    const std::size_t count = map.width * map.height;
    map.values.reserve(std::min(count, rest_.size()));  // a value takes two bytes at least
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = number("a cell's value", 0, map.max_value);
      if (!value) return false;
      map.values.push_back(static_cast<std::uint16_t>(*value));
    }
    return true;
  }

  bool read_binary(Graymap& map) {
    const std::size_t count = map.width * map.height;
    const std::size_t width = map.max_value < 256 ? 1 : 2;
    if (!rest_.empty()) rest_.remove_prefix(1);  // the one blank after the header
    if (rest_.size() < count * width) {
      blame_(path_in_quotes(file_) + " ends after " + std::to_string(rest_.size() / width) +
             " of " + std::to_string(count) + " cells");
      return false;
    }
    map.values.reserve(count);
    const auto byte = [&](std::size_t i) {
      return static_cast<unsigned>(static_cast<unsigned char>(rest_[i]));
    };
    for (std::size_t i = 0; i < count; ++i) {
      const unsigned value = width == 1 ? byte(i) : (byte(2 * i) << 8U) + byte(2 * i + 1);
      if (value > map.max_value) {
        blame_("the cell " + std::to_string(i) + " of " + path_in_quotes(file_) + " is " +
               std::to_string(value) + "; expected at most white, " +
               std::to_string(map.max_value));
        return false;
      }
      map.values.push_back(static_cast<std::uint16_t>(value));
    }
    return true;
  }

  std::string_view rest_;
  int line_ = 1;
  const std::string& file_;
  const Blame& blame_;
  Faults& faults_;
};

}  // namespace

std::optional<Graymap> parse_pgm(std::string_view bytes, const std::string& file,
                                 const Blame& blame, Faults& faults) {
  return PgmParser(bytes, file, blame, faults).parse();
}

}  // namespace accord
