#include "common/io/movingai_map.h"

#include <charconv>

#include "common/io/limits.h"
#include "common/io/line_reader.h"
#include "common/io/words.h"

namespace accord {
namespace {

constexpr std::string_view kFree = ".G";
constexpr std::string_view kBlocked = "@OTSW";

class MapParser {
 public:
  MapParser(std::string_view text, const std::string& file, Faults& faults)
      : lines_(text), file_(file), faults_(faults) {}

  std::optional<Grid> parse() {
    Grid grid;
    if (!header_word("type", "octile")) return std::nullopt;
    const auto height = header_size("height");
    const auto width = height ? header_size("width") : std::nullopt;
    if (!width || !header_word("map", "")) return std::nullopt;
    if (*width * *height > limits::kMapCells) {
      fault("width", std::to_string(*width) + " x " + std::to_string(*height) +
                         " cells; expected at most " + std::to_string(limits::kMapCells));
      return std::nullopt;
    }
    grid.width = *width;
    grid.height = *height;
    grid.blocked.resize(grid.width * grid.height);
    if (!rows(grid)) return std::nullopt;
    return grid;
  }

 private:
  void fault(std::string_view key, std::string_view text) {
    faults_.add(file_, lines_.number(), key, text);
  }

  // The rest of the next line after `key`.
  std::optional<std::string_view> header(std::string_view key) {
    if (!lines_.next()) {
      fault(key, "the file ends before the header does; expected the line " + in_quotes(key));
      return std::nullopt;
    }
    std::string_view rest = lines_.line();
    const std::string_view word = take_word(rest);
    if (word != key) {
      fault(key, "expected the line " + in_quotes(key) + ", not " + in_quotes(lines_.line()));
      return std::nullopt;
    }
    return rest;
  }

  bool header_word(std::string_view key, std::string_view expected) {
    auto rest = header(key);
    if (!rest) return false;
    const std::string_view word = take_word(*rest);
    if (word == expected) return true;
    fault(key, "expected " + in_quotes(expected) + ", not " + in_quotes(word));
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
      fault(key, "expected a number of cells from 1 to " + std::to_string(limits::kMapSide) +
                     ", not " + in_quotes(word));
      return std::nullopt;
    }
    return size;
  }

  bool rows(Grid& grid) {
    bool sound = true;
    for (std::size_t i = 0; i < grid.height; ++i) {
      if (!lines_.next()) {
        fault("map", "the file ends after " + std::to_string(i) + " rows; expected " +
                         std::to_string(grid.height));
        return false;
      }
      sound = row(grid, grid.height - 1 - i) && sound;
    }
    while (lines_.next()) {
      if (lines_.line().find_first_not_of(" \t") == std::string_view::npos) continue;
      fault("map", "more rows than the height of " + std::to_string(grid.height));
      return false;
    }
    return sound;
  }

  bool row(Grid& grid, std::size_t y) {
    const std::string_view line = lines_.line();
    if (line.size() != grid.width) {
      fault("map", "a row of " + std::to_string(line.size()) + " cells; expected the width of " +
                       std::to_string(grid.width));
      return false;
    }
    for (std::size_t x = 0; x < grid.width; ++x) {
      const bool free = kFree.find(line[x]) != std::string_view::npos;
      if (!free && kBlocked.find(line[x]) == std::string_view::npos) {
        fault("map", "the cell " + in_quotes(line.substr(x, 1)) + " in column " +
                         std::to_string(x + 1) + "; expected one of . G @ O T S W");
        return false;
      }
      grid.blocked[y * grid.width + x] = free ? 0 : 1;
    }
    return true;
  }

  LineReader lines_;
  const std::string& file_;
  Faults& faults_;
};

}  // namespace

std::optional<Grid> parse_movingai_map(std::string_view text, const std::string& file,
                                       Faults& faults) {
  return MapParser(text, file, faults).parse();
}

}  // namespace accord
