// A YAML or JSON document as a tree in which every value knows its line and its path, so that
// whatever is found wrong with it later can be said with its place. Compact: 28 bytes a value.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace accord {

enum class ValueKind : std::uint8_t {
  kNull,
  kPlain,   // a scalar without quotes: a number, true, or a word
  kQuoted,  // a string in quotes
  kList,
  kMap,
};

class Document;

// A value inside a document, which must outlive it. Cheap to copy.
class Value {
 public:
  Value(const Document& document, std::uint32_t index) : document_(&document), index_(index) {}

  ValueKind kind() const;
  bool is_null() const { return kind() == ValueKind::kNull; }
  bool is_list() const { return kind() == ValueKind::kList; }
  bool is_map() const { return kind() == ValueKind::kMap; }
  bool is_scalar() const { return kind() == ValueKind::kPlain || kind() == ValueKind::kQuoted; }

  std::string_view text() const;  // of a scalar; empty for the rest
  int line() const;               // from 1
  std::size_t size() const;       // items of a list, entries of a map

  // What it is in words, for messages: `"abc"`, `the string "abc"`, `a list of 3`,
  // `a map`, `nothing`.
  std::string in_words() const;
  // Where it is, as in robots[4].goal; empty for the document's root.
  std::string path() const;
  const std::string& file() const;

  // The items of a list. A map's are key, value, key, value ...
  class Iterator {
   public:
    Iterator(const Document* document, std::uint32_t index) : document_(document), index_(index) {}
    Value operator*() const { return {*document_, index_}; }
    Iterator& operator++();
    bool operator==(const Iterator& other) const { return index_ == other.index_; }

   private:
    const Document* document_;
    std::uint32_t index_;
  };
  Iterator begin() const;
  Iterator end() const;

 private:
  const Document* document_;
  std::uint32_t index_;
};

class Document {
 public:
  explicit Document(std::string file) : file_(std::move(file)) {}
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  // Require: something was added, first and last.
  Value root() const { return {*this, 0}; }
  Value last() const { return {*this, static_cast<std::uint32_t>(nodes_.size() - 1)}; }
  const std::string& file() const { return file_; }
  std::size_t size() const { return nodes_.size(); }
  bool empty() const { return nodes_.empty(); }

  // Building, in document order: values go into the list or map that was opened last.
  void add(ValueKind kind, std::string_view text, int line);
  void open(ValueKind kind, int line);
  void close();
  std::size_t depth() const { return open_.size(); }

 private:
  friend class Value;
  static constexpr std::uint32_t kNone = UINT32_MAX;
  struct Node {
    std::uint32_t parent;
    std::uint32_t first = kNone;  // child
    std::uint32_t next = kNone;   // sibling
    std::uint32_t text_begin = 0;
    std::uint32_t text_size = 0;
    std::uint32_t line;
    ValueKind kind;
  };
  struct Open {
    std::uint32_t node;
    std::uint32_t last_child;
  };

  std::string file_;
  std::string text_;  // of all scalars, one after the other
  std::vector<Node> nodes_;
  std::vector<Open> open_;
};

}  // namespace accord
