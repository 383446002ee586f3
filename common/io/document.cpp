#include "common/io/document.h"

#include "common/io/words.h"

namespace accord {

ValueKind Value::kind() const {
  return document_->nodes_[index_].kind;
}

int Value::line() const {
  return static_cast<int>(document_->nodes_[index_].line);
}

std::string_view Value::text() const {
  const Document::Node& node = document_->nodes_[index_];
  return std::string_view(document_->text_).substr(node.text_begin, node.text_size);
}

const std::string& Value::file() const {
  return document_->file_;
}

Value::Iterator Value::begin() const {
  return {document_, document_->nodes_[index_].first};
}
Value::Iterator Value::end() const {
  return {document_, Document::kNone};
}

Value::Iterator& Value::Iterator::operator++() {
  index_ = document_->nodes_[index_].next;
  return *this;
}

std::size_t Value::size() const {
  std::size_t count = 0;
  for (auto it = begin(); it != end(); ++it) ++count;
  return is_map() ? count / 2 : count;
}

std::string Value::in_words() const {
  switch (kind()) {
    case ValueKind::kNull:
      return "nothing";
    case ValueKind::kPlain:
      return in_quotes(text());
    case ValueKind::kQuoted:
      return "the string " + in_quotes(text());
    case ValueKind::kList:
      return "a list of " + std::to_string(size());
    case ValueKind::kMap:
      return "a map";
  }
  return "";
}

std::string Value::path() const {
  const std::uint32_t parent_index = document_->nodes_[index_].parent;
  if (parent_index == Document::kNone) return "";
  const Value parent(*document_, parent_index);
  const std::string prefix = parent.path();
  std::size_t position = 0;
  std::string_view key;
  for (const Value sibling : parent) {
    if (position % 2 == 0) key = sibling.text();
    if (sibling.index_ == index_) break;
    ++position;
  }
  if (parent.is_list()) return prefix + "[" + std::to_string(position) + "]";
  // Keys are names most of the time; whatever else they are has to stay printable.
  const std::string shown = in_quotes(key);
  return (prefix.empty() ? "" : prefix + ".") + shown.substr(1, shown.size() - 2);
}

void Document::add(ValueKind kind, std::string_view text, int line) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({.parent = open_.empty() ? kNone : open_.back().node,
                    .text_begin = static_cast<std::uint32_t>(text_.size()),
                    .text_size = static_cast<std::uint32_t>(text.size()),
                    .line = static_cast<std::uint32_t>(line),
                    .kind = kind});
  text_ += text;
  if (open_.empty()) return;
  Open& parent = open_.back();
  if (parent.last_child == kNone) {
    nodes_[parent.node].first = index;
  } else {
    nodes_[parent.last_child].next = index;
  }
  parent.last_child = index;
}

void Document::open(ValueKind kind, int line) {
  add(kind, "", line);
  open_.push_back({static_cast<std::uint32_t>(nodes_.size()) - 1, kNone});
}

void Document::close() {
  open_.pop_back();
}

}  // namespace accord
