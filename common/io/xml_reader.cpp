#include "common/io/xml_reader.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <vector>

#include "common/io/limits.h"
#include "common/io/line_reader.h"
#include "common/io/pose_fields.h"
#include "common/io/words.h"

namespace accord {
namespace {

constexpr Range kAnyNumber{-1e12, 1e12, ""};

bool holds(Range range, double value) {
  return value >= range.min && value <= range.max;
}

std::optional<double> number_in(std::string_view word, Range range) {
  const auto value = parse_number(word);
  if (!value || !holds(range, *value)) return std::nullopt;
  return value;
}

// "from 1e-05 to 100000 m".
std::string range_in_words(Range range) {
  const std::string unit = range.unit.empty() ? "" : " " + std::string(range.unit);
  return "from " + in_words(range.min) + " to " + in_words(range.max) + unit;
}

// Where the first equals sign beyond kXmlAttributes stands; npos where there is none.
std::size_t one_attribute_too_many(std::string_view text) {
  std::size_t at = text.find('=');
  for (std::size_t count = 0; count < limits::kXmlAttributes && at != std::string_view::npos;
       ++count) {
    at = text.find('=', at + 1);
  }
  return at;
}

}  // namespace

bool parse_xml(std::string_view text, const std::string& file, tinyxml2::XMLDocument& document,
               Faults& faults) {
  if (const std::size_t bad = one_attribute_too_many(text); bad != std::string_view::npos) {
    faults.add(file, line_at(text, bad), "",
               "more than " + std::to_string(limits::kXmlAttributes) + " attributes");
    return false;
  }
  if (const std::size_t bad = first_unprintable(text); bad != std::string_view::npos) {
    faults.add(file, line_at(text, bad), "",
               "not text: the byte " + in_quotes(text.substr(bad, 1)) + "; expected UTF-8");
    return false;
  }
  if (document.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS) return true;
  std::string reason = document.ErrorName();
  if (reason.starts_with("XML_")) reason = reason.substr(4);
  std::ranges::transform(reason, reason.begin(), [](unsigned char c) {
    return c == '_' ? ' ' : static_cast<char>(std::tolower(c));
  });
  faults.add(file, std::max(1, document.ErrorLineNum()), "", "not valid XML: " + reason);
  return false;
}

void XmlElement::fault(const char* attribute, std::string_view text) const {
  faults_->add(*file_, element_->GetLineNum(), attribute_key(attribute), text);
}

std::optional<XmlElement> XmlElement::child(const char* name) const {
  const tinyxml2::XMLElement* found = element_->FirstChildElement(name);
  if (found == nullptr) return std::nullopt;
  XmlElement result = with_key(*found, attribute_key(name));
  if (const auto* second = found->NextSiblingElement(name)) {
    with_key(*second, attribute_key(name))
        .fault("given twice; the first is in line " + std::to_string(found->GetLineNum()));
  }
  return result;
}

std::optional<XmlElement> XmlElement::required_child(const char* name) const {
  auto found = child(name);
  if (!found) fault(name, "missing; expected an element <" + std::string(name) + ">");
  return found;
}

std::optional<std::string> XmlElement::name(const char* attribute) const {
  const char* text = element_->Attribute(attribute);
  if (text == nullptr || *text == '\0') {
    fault(attribute, "missing; expected a name");
    return std::nullopt;
  }
  const std::string_view name(text);
  // Characters that are written as numbers, as in &#1;, may be any.
  if (name.size() > limits::kNameBytes || name.find_first_of("\t\r\n") != std::string_view::npos ||
      first_unprintable(name) != std::string_view::npos) {
    fault(attribute, "expected a name of at most " + std::to_string(limits::kNameBytes) +
                         " bytes in one line, not " + in_quotes(name));
    return std::nullopt;
  }
  return std::string(name);
}

std::optional<double> XmlElement::number(const char* attribute, Range range) const {
  const char* text = element_->Attribute(attribute);
  if (text == nullptr) {
    fault(attribute, "missing; expected a number");
    return std::nullopt;
  }
  std::string_view rest(text);
  const std::string_view word = take_word(rest);
  const auto any = take_word(rest).empty() ? number_in(word, kAnyNumber) : std::nullopt;
  if (!any) {
    fault(attribute, "expected a finite number, not " + in_quotes(text));
    return std::nullopt;
  }
  if (holds(range, *any)) return any;
  const std::string unit = range.unit.empty() ? "" : " " + std::string(range.unit);
  const bool sign = range.min > 0 && *any <= 0;
  fault(attribute,
        (sign ? "must be greater than 0" + unit : "expected a number " + range_in_words(range)) +
            ", not " + in_words(*any));
  return std::nullopt;
}

std::optional<Vec3> XmlElement::vector(const char* attribute, Range range) const {
  const char* text = element_->Attribute(attribute);
  if (text == nullptr) {
    fault(attribute, "missing; expected three numbers");
    return std::nullopt;
  }
  Vec3 out = Vec3::Zero();
  std::string_view rest(text);
  bool numbers = true;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto value = number_in(take_word(rest), kAnyNumber);
    numbers = numbers && value;
    out[i] = value.value_or(0);
  }
  numbers = numbers && take_word(rest).empty();
  if (numbers && holds(range, out.minCoeff()) && holds(range, out.maxCoeff())) return out;
  const bool sign = range.min > 0 && out.minCoeff() <= 0;
  const std::string expected = sign      ? "three numbers greater than 0"
                               : numbers ? "three numbers " + range_in_words(range)
                                         : "three finite numbers";
  fault(attribute, "expected " + expected + ", not " + in_quotes(text));
  return std::nullopt;
}

void XmlElement::report_misspelt(std::initializer_list<std::string_view> known) const {
  const std::vector<std::string_view> words(known);
  for (const auto* it = element_->FirstChildElement(); it != nullptr && !faults_->full();
       it = it->NextSiblingElement()) {
    const std::string_view name(it->Name());
    if (std::ranges::find(words, name) != words.end()) continue;
    if (const auto nearest = nearest_word(name, words)) {
      with_key(*it, key_).fault("unknown element <" + std::string(name.substr(0, 60)) +
                                ">; did you mean <" + std::string(*nearest) + ">?");
    }
  }
}

Pose read_origin(const XmlElement& element) {
  const auto origin = element.child("origin");
  if (!origin) return Pose::Identity();
  const auto xyz = origin->has("xyz") ? origin->vector("xyz", kCoordinateRange) : std::nullopt;
  const auto rpy = origin->has("rpy") ? origin->vector("rpy", kAngleRange) : std::nullopt;
  return make_pose(xyz.value_or(Vec3::Zero()), rpy.value_or(Vec3::Zero()));
}

}  // namespace accord
