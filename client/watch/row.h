// What is shown of one request, worker or service: named values, which become a row of a table, a
// line of text or an object of JSON. Plain values; pure functions; thread safe.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace accord {

struct Seconds {
  double count = 0;
};

struct Field {
  const char* name;     // in lines and JSON
  const char* heading;  // of its column; empty: not in tables
  // A text may be anything that came over the network.
  std::variant<std::string, std::uint64_t, bool, Seconds> value;

  bool is_text() const { return value.index() == 0; }
  bool is_empty() const;  // an empty text, a time that is not known (not a number)
};

using Row = std::vector<Field>;

// As a table's cell: 1.2 s, 0:01:02, yes. Printable ASCII of at most 200 characters.
std::string cell_of(const Field& field);

// One line without its end: "request id=a phase=conflicts elapsed=1.2". Texts that hold anything
// but printable ASCII without spaces, quotes and equals signs are quoted as in JSON; empty fields
// are left out.
std::string line_of(std::string_view kind, const Row& row);

// One line without its end: {"kind": "request", "id": "a", ...}, in ASCII. Empty `time`: none.
std::string json_of(std::string_view kind, const Row& row, std::string_view time = {});

}  // namespace accord
