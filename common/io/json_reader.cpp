#include "common/io/json_reader.h"

#include <array>
#include <charconv>
#include <iterator>
#include <nlohmann/json.hpp>

#include "common/io/limits.h"
#include "common/io/words.h"

namespace accord {
namespace {

// Where the lexer stands. Numbers end only at the byte after them, which may be a line feed.
struct Position {
  int line = 1;
  bool after_line_feed = false;

  int of_token() const { return after_line_feed ? line - 1 : line; }
};

// Hands out bytes and keeps count of lines: nlohmann's SAX events carry no positions.
class CountingIterator {
 public:
  using difference_type = std::ptrdiff_t;
  using value_type = char;
  using pointer = const char*;
  using reference = const char&;
  using iterator_category = std::input_iterator_tag;

  CountingIterator(const char* at, Position* position) : at_(at), position_(position) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    position_->after_line_feed = *at_ == '\n';
    if (*at_ == '\n') ++position_->line;
    ++at_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  Position* position_;
};

class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(Document& document, const Position& position, std::size_t max_values, Faults& faults)
      : document_(document), position_(position), max_values_(max_values), faults_(faults) {}

  bool null() override { return add(ValueKind::kNull, ""); }
  bool boolean(bool value) override { return add(ValueKind::kPlain, value ? "true" : "false"); }
  bool number_integer(number_integer_t value) override { return add_integer(value); }
  bool number_unsigned(number_unsigned_t value) override { return add_integer(value); }
  bool number_float(number_float_t, const string_t& text) override {
    return add(ValueKind::kPlain, text);
  }
  bool string(string_t& value) override { return add(ValueKind::kQuoted, value); }
  bool key(string_t& value) override { return add(ValueKind::kQuoted, value); }
  bool binary(binary_t&) override { return false; }  // never in text

  bool start_object(std::size_t) override { return open(ValueKind::kMap); }
  bool start_array(std::size_t) override { return open(ValueKind::kList); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool parse_error(std::size_t, const std::string& token,
                   const nlohmann::json::exception& error) override {
    if (error.id == 406) return refuse("the number " + in_quotes(token) + " is too large");
    return refuse("not valid JSON near " + in_quotes(token));
  }

 private:
  template <typename Integer>
  bool add_integer(Integer value) {
    std::array<char, 24> text{};
    const auto end = std::to_chars(text.begin(), text.end(), value).ptr;
    return add(ValueKind::kPlain, {text.data(), static_cast<std::size_t>(end - text.data())});
  }

  bool refuse(std::string_view text) {
    faults_.add(document_.file(), position_.of_token(), "", text);
    return false;
  }

  bool room() {
    return document_.size() < max_values_ ||
           refuse("more than " + std::to_string(max_values_) + " keys and values");
  }

  bool add(ValueKind kind, std::string_view text) {
    if (!room()) return false;
    document_.add(kind, text, position_.of_token());
    return true;
  }

  bool open(ValueKind kind) {
    if (!room()) return false;
    if (document_.depth() >= limits::kNesting) {
      return refuse("nested more than " + std::to_string(limits::kNesting) + " levels deep");
    }
    document_.open(kind, position_.of_token());
    return true;
  }

  bool close() {
    document_.close();
    return true;
  }

  Document& document_;
  const Position& position_;
  std::size_t max_values_;
  Faults& faults_;
};

}  // namespace

std::unique_ptr<const Document> read_json(std::string_view text, const std::string& file,
                                          std::size_t max_values, Faults& faults) {
  auto document = std::make_unique<Document>(file);
  Position position;
  Builder builder(*document, position, max_values, faults);
  const bool read =
      nlohmann::json::sax_parse(CountingIterator(text.data(), &position),
                                CountingIterator(text.data() + text.size(), &position), &builder);
  if (!read) return nullptr;
  return document;
}

}  // namespace accord
