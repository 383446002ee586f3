#include "common/io/yaml_reader.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <istream>
#include <streambuf>
#include <vector>

#include "common/io/limits.h"
#include "common/io/words.h"

namespace accord {
namespace {

// Thrown from within yaml-cpp's parser to end it at once, the fault reported; caught below.
struct Refusal {};

int line_of(const YAML::Mark& mark) {
  return mark.line + 1;
}

// Turns yaml-cpp's events into a Document. Events rather than YAML::Node: they carry positions,
// keep duplicate keys, and can be stopped at the first sign of abuse.
class Builder : public YAML::EventHandler {
 public:
  Builder(Document& document, std::size_t max_values, Faults& faults)
      : document_(document), max_values_(max_values), faults_(faults) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (!document_.empty()) refuse(mark, "a second document starts here; expected one");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    check_room(mark);
    if (at_key()) refuse(mark, "a key is empty");
    add(mark, ValueKind::kNull, "");
    check_plain(mark, "", anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    check_room(mark);
    add(mark, ValueKind::kPlain, "*");  // what it stands for matters no more
    report(mark, "aliases (*name) are not supported; write values out");
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    check_room(mark);
    const bool plain = tag != "!";
    const bool null = plain && (value.empty() || value == "~" || value == "null");
    if (at_key() && null) refuse(mark, "a key is empty");
    const ValueKind kind = plain ? ValueKind::kPlain : ValueKind::kQuoted;
    add(mark, null ? ValueKind::kNull : kind, null ? "" : std::string_view(value));
    check_plain(mark, tag, anchor);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, ValueKind::kList);
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, ValueKind::kMap);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Level {
    bool map;
    std::size_t items;
  };

  [[noreturn]] void refuse(const YAML::Mark& mark, std::string_view text) const {
    faults_.add(document_.file(), line_of(mark), "", text);
    throw Refusal{};
  }

  // Blames the value that was added last, and goes on: there may be more.
  void report(const YAML::Mark& mark, std::string_view text) const {
    faults_.add(document_.file(), line_of(mark), document_.last().path(), text);
    if (faults_.full()) throw Refusal{};
  }

  void check_room(const YAML::Mark& mark) const {
    if (document_.size() < max_values_) return;
    refuse(mark, "more than " + std::to_string(max_values_) + " keys and values");
  }

  void check_plain(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) const {
    if (anchor != YAML::NullAnchor) {
      report(mark, "anchors (&name) are not supported; write values out");
    }
    if (!tag.empty() && tag != "?" && tag != "!") {
      report(mark, "the tag " + in_quotes(tag) + " is not supported; expected plain values");
    }
  }

  bool at_key() const {
    return !levels_.empty() && levels_.back().map && levels_.back().items % 2 == 0;
  }

  void count() {
    if (!levels_.empty()) ++levels_.back().items;
  }

  void add(const YAML::Mark& mark, ValueKind kind, std::string_view text) {
    count();
    document_.add(kind, text, line_of(mark));
  }

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, ValueKind kind) {
    check_room(mark);
    if (at_key()) refuse(mark, "a key must be a word, not a list or a map");
    if (levels_.size() >= limits::kNesting) {
      refuse(mark, "nested more than " + std::to_string(limits::kNesting) + " levels deep");
    }
    count();
    levels_.push_back({kind == ValueKind::kMap, 0});
    document_.open(kind, line_of(mark));
    check_plain(mark, tag, anchor);
  }

  void close() {
    levels_.pop_back();
    document_.close();
  }

  Document& document_;
  std::size_t max_values_;
  Faults& faults_;
  std::vector<Level> levels_;
};

// A stream over text that is not copied.
class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(std::string_view text) {
    char* begin = const_cast<char*>(text.data());  // only ever read
    setg(begin, begin, begin + text.size());
  }
};

// Where more brackets are open than any scene needs, quotes and comments disregarded; npos where
// nowhere. yaml-cpp keeps a token for each until it meets the end, at 250 bytes for one.
std::size_t too_many_brackets(std::string_view text) {
  std::size_t open = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '[' || text[i] == '{') ++open;
    if ((text[i] == ']' || text[i] == '}') && open > 0) --open;
    if (open > limits::kOpenBrackets) return i;
  }
  return std::string_view::npos;
}

}  // namespace

std::unique_ptr<const Document> read_yaml(std::string_view text, const std::string& file,
                                          std::size_t max_values, Faults& faults) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark
  if (const std::size_t bad = first_unprintable(text); bad != std::string_view::npos) {
    faults.add(file, line_at(text, bad), "",
               "not text: the byte " + in_quotes(text.substr(bad, 1)) + "; expected UTF-8");
    return nullptr;
  }
  if (const std::size_t bad = too_many_brackets(text); bad != std::string_view::npos) {
    faults.add(file, line_at(text, bad), "",
               "more than " + std::to_string(limits::kOpenBrackets) +
                   " brackets are open at once; expected at most " +
                   std::to_string(limits::kNesting) + " levels of nesting");
    return nullptr;
  }
  const std::size_t before = faults.count();
  auto document = std::make_unique<Document>(file);
  try {
    TextBuffer buffer(text);
    std::istream stream(&buffer);
    YAML::Parser parser(stream);
    Builder builder(*document, max_values, faults);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const Refusal&) {
    return nullptr;
  } catch (const YAML::Exception& error) {
    faults.add(file, error.mark.is_null() ? 0 : line_of(error.mark), "",
               "not valid YAML: " + error.msg);
    return nullptr;
  }
  if (document->empty()) faults.add(file, 1, "", "the file is empty; expected a map of keys");
  if (faults.count() != before) return nullptr;
  return document;
}

}  // namespace accord
