#include "client/watch/columns.h"

#include <fmt/format.h>

#include <algorithm>

#include "client/terminal_text.h"

namespace accord {
namespace {

constexpr std::string_view kGap = "  ";
constexpr std::size_t kNarrowest = 8;  // a text is not cut to less, the line is

struct Column {
  std::string heading;
  bool is_text;
  std::vector<std::string> cells;
  std::size_t width;
};

std::vector<Column> columns_of(const std::vector<Row>& rows) {
  std::vector<Column> out;
  for (std::size_t i = 0; i < rows.front().size(); ++i) {
    const Field& first = rows.front()[i];
    if (*first.heading == '\0') continue;
    Column column{first.heading, first.is_text(), {}, 0};
    for (const Row& row : rows) {
      column.cells.push_back(cell_of(row[i]));
      column.width = std::max(column.width, column.cells.back().size());
    }
    if (column.width == 0) continue;
    column.width = std::max(column.width, column.heading.size());
    out.push_back(std::move(column));
  }
  return out;
}

std::size_t width_of(const std::vector<Column>& columns) {
  std::size_t width = 0;
  for (const Column& column : columns) width += column.width + kGap.size();
  return columns.empty() ? 0 : width - kGap.size();
}

void narrow(std::vector<Column>& columns, std::size_t width) {
  while (width_of(columns) > width) {
    Column* widest = nullptr;
    for (Column& column : columns) {
      if (!column.is_text || column.width <= kNarrowest) continue;
      if (widest == nullptr || column.width > widest->width) widest = &column;
    }
    if (widest == nullptr) return;
    --widest->width;
  }
}

std::string padded(const Column& column, const std::string& text) {
  const std::string shown = terminal_text(text, column.width);
  return column.is_text ? fmt::format("{:<{}}", shown, column.width)
                        : fmt::format("{:>{}}", shown, column.width);
}

template <typename TextOf>
std::string line(const std::vector<Column>& columns, std::size_t width, const TextOf& text_of) {
  std::string out;
  for (const Column& column : columns) {
    if (!out.empty()) out += kGap;
    out += padded(column, text_of(column));
  }
  if (out.size() > width) out.resize(width);
  out.resize(out.find_last_not_of(' ') + 1);
  return out;
}

}  // namespace

std::vector<std::string> in_columns(const std::vector<Row>& rows, std::size_t width) {
  if (rows.empty()) return {};
  std::vector<Column> columns = columns_of(rows);
  narrow(columns, width);
  std::vector<std::string> out;
  out.push_back(line(columns, width, [](const Column& column) { return column.heading; }));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out.push_back(line(columns, width, [i](const Column& column) { return column.cells[i]; }));
  }
  return out;
}

}  // namespace accord
