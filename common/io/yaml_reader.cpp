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

// Thrown from within yaml-cpp's parser to end it at once; caught below.
struct Refusal {
  int line;
  std::string key;
  std::string text;
};

int line_of(const YAML::Mark& mark) {
  return mark.line + 1;
}

// Turns yaml-cpp's events into a Document. Events rather than YAML::Node: they carry positions,
// keep duplicate keys, and can be stopped at the first sign of abuse.
class Builder : public YAML::EventHandler {
 public:
  Builder(Document& document, std::size_t max_values)
      : document_(document), max_values_(max_values) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (!document_.empty()) refuse(mark, "a second document starts here; expected one");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    check(mark, "", anchor);
    if (at_key()) refuse(mark, "a key is empty");
    count();
    document_.add(ValueKind::kNull, "", line_of(mark));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse(mark, "aliases (*name) are not supported; write values out");
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    check(mark, tag, anchor);
    const bool plain = tag != "!";
    const bool null = plain && (value.empty() || value == "~" || value == "null");
    if (at_key() && null) refuse(mark, "a key is empty");
    count();
    const ValueKind kind = plain ? ValueKind::kPlain : ValueKind::kQuoted;
    document_.add(null ? ValueKind::kNull : kind, null ? "" : std::string_view(value),
                  line_of(mark));
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

  [[noreturn]] void refuse(const YAML::Mark& mark, std::string text) const {
    throw Refusal{line_of(mark), "", std::move(text)};
  }

  void check(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) const {
    if (anchor != YAML::NullAnchor)
      refuse(mark, "anchors (&name) are not supported; write values out");
    if (!tag.empty() && tag != "?" && tag != "!") {
      refuse(mark, "the tag " + in_quotes(tag) + " is not supported; expected plain values");
    }
    if (document_.size() >= max_values_) {
      refuse(mark, "more than " + std::to_string(max_values_) + " keys and values");
    }
  }

  bool at_key() const {
    return !levels_.empty() && levels_.back().map && levels_.back().items % 2 == 0;
  }

  void count() {
    if (!levels_.empty()) ++levels_.back().items;
  }

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, ValueKind kind) {
    check(mark, tag, anchor);
    if (at_key()) refuse(mark, "a key must be a word, not a list or a map");
    if (levels_.size() >= limits::kNesting) {
      refuse(mark, "nested more than " + std::to_string(limits::kNesting) + " levels deep");
    }
    count();
    levels_.push_back({kind == ValueKind::kMap, 0});
    document_.open(kind, line_of(mark));
  }

  void close() {
    levels_.pop_back();
    document_.close();
  }

  Document& document_;
  std::size_t max_values_;
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

int line_at(std::string_view text, std::size_t position) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(position);
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
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
               "more than " + std::to_string(limits::kOpenBrackets) + " brackets are open at once");
    return nullptr;
  }
  auto document = std::make_unique<Document>(file);
  try {
    TextBuffer buffer(text);
    std::istream stream(&buffer);
    YAML::Parser parser(stream);
    Builder builder(*document, max_values);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const Refusal& refusal) {
    faults.add(file, refusal.line, refusal.key, refusal.text);
    return nullptr;
  } catch (const YAML::Exception& error) {
    faults.add(file, error.mark.is_null() ? 0 : line_of(error.mark), "",
               "not valid YAML: " + error.msg);
    return nullptr;
  }
  if (document->empty()) {
    faults.add(file, 0, "", "the file is empty");
    return nullptr;
  }
  return document;
}

}  // namespace accord
