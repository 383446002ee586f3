#include "common/io/movingai_map.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "common/io/limits.h"
#include "common/io/line_faults.h"
#include "common/io/line_reader.h"
#include "common/io/words.h"

namespace accord {
namespace {

constexpr std::array<std::string_view, 4> kHeader = {"type", "height", "width", "map"};
constexpr std::string_view kFree = ".G";
constexpr std::string_view kBlocked = "@OTSW";

class MapParser {
 public:
  MapParser(std::string_view text, const std::string& file, Faults& faults)
      : lines_(text), faults_(lines_, file, faults) {}

  std::optional<Grid> parse() {
    // Each line for itself, so that one at fault hides no other.
    const bool octile = header_word("type", "octile");
    const auto height = header_size("height");
    const auto width = header_size("width");
    const bool begun = header_word("map", "");
    if (!octile || !height || !width || !begun) return std::nullopt;
    if (*width * *height > limits::kMapCells) {
      faults_.add(std::to_string(*width) + " x " + std::to_string(*height) +
                      " cells; expected at most " + std::to_string(limits::kMapCells),
                  "width");
      return std::nullopt;
    }
    Grid grid{*width, *height, std::vector<std::uint8_t>(*width * *height)};
    rows(grid);
    if (faults_.any()) return std::nullopt;
    return grid;
  }

 private:
  // The rest of the next line after `key`. A line of a later key stays for that one: what is at
  // fault is that one line is missing.
  std::optional<std::string_view> header(std::string_view key) {
    if (faults_.over()) return std::nullopt;
    if (!held_ && !lines_.next()) {
      faults_.give_up("the file ends before the header does; expected the line " + in_quotes(key),
                      key);
      return std::nullopt;
    }
    std::string_view rest = lines_.line();
    const std::string_view word = take_word(rest);
    const auto found = std::ranges::find(kHeader, word);
    held_ = found != kHeader.end() && found > std::ranges::find(kHeader, key);
    if (word == key) return rest;
    faults_.add("expected the line " + in_quotes(key) + ", not " + in_quotes(lines_.line()), key);
    return std::nullopt;
  }

  bool header_word(std::string_view key, std::string_view expected) {
    auto rest = header(key);
    if (!rest) return false;
    const std::string_view word = take_word(*rest);
    if (word == expected) return true;
    faults_.add("expected " + in_quotes(expected) + ", not " + in_quotes(word), key);
    return false;
  }

  std::optional<std::size_t> header_size(std::string_view key) {
    auto rest = header(key);
    if (!rest) return std::nullopt;
    const std::string_view word = take_word(*rest);
    std::size_t size = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), size);
    if (error != std::errc() || end != word.data() + word.size() || size == 0 ||
        size > limits::kMapSide || !take_word(*rest).empty()) {
      faults_.add("expected a number of cells from 1 to " + std::to_string(limits::kMapSide) +
                      ", not " + in_quotes(word),
                  key);
      return std::nullopt;
    }
    return size;
  }

  void rows(Grid& grid) {
    for (std::size_t i = 0; i < grid.height && !faults_.over(); ++i) {
      if (!lines_.next()) {
        return faults_.add("the file ends after " + std::to_string(i) + " rows; expected " +
                               std::to_string(grid.height),
                           "map");
      }
      row(grid, grid.height - 1 - i);
    }
    while (!faults_.over() && lines_.next()) {
      if (lines_.line().find_first_not_of(" \t") == std::string_view::npos) continue;
      return faults_.add("more rows than the height of " + std::to_string(grid.height), "map");
    }
  }

  void row(Grid& grid, std::size_t y) {
    const std::string_view line = lines_.line();
    if (line.size() != grid.width) {
      return faults_.add("a row of " + std::to_string(line.size()) +
                             " cells; expected the width of " + std::to_string(grid.width),
                         "map");
    }
    for (std::size_t x = 0; x < grid.width; ++x) {
      const bool free = kFree.find(line[x]) != std::string_view::npos;
      if (!free && kBlocked.find(line[x]) == std::string_view::npos) {
        return faults_.add("the cell " + in_quotes(line.substr(x, 1)) + " in column " +
                               std::to_string(x + 1) + "; expected one of . G @ O T S W",
                           "map");
      }
      grid.blocked[y * grid.width + x] = free ? 0 : 1;
    }
  }

  LineReader lines_;
  LineFaults faults_;
  bool held_ = false;  // the current line is still to be read
};

}  // namespace

std::optional<Grid> parse_movingai_map(std::string_view text, const std::string& file,
                                       Faults& faults) {
  return MapParser(text, file, faults).parse();
}

}  // namespace accord
