// XML elements read with positions: what URDF and SRDF have in common. Faults are reported with the
// element's file and line, and a key such as joint[elbow].limit.velocity.
#pragma once

#include <tinyxml2.h>

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "common/io/diagnostic.h"
#include "common/io/fields.h"
#include "common/model/shape.h"

namespace accord {

// Parses text into `document`; false where it is no XML, or too much of it (kXmlAttributes).
// Entities are not expanded by tinyxml2, and nesting is bounded by it.
bool parse_xml(std::string_view text, const std::string& file, tinyxml2::XMLDocument& document,
               Faults& faults);

// One element and the name it goes by in messages. Valid as long as its document and file name.
class XmlElement {
 public:
  XmlElement(const tinyxml2::XMLElement& element, std::string key, const std::string& file,
             Faults& faults)
      : element_(&element), key_(std::move(key)), file_(&file), faults_(&faults) {}

  Place place() const { return {*file_, element_->GetLineNum(), key_}; }
  void fault(std::string_view text) const { faults_->add(place(), text); }
  void fault(const char* attribute, std::string_view text) const;
  const std::string& key() const { return key_; }
  const tinyxml2::XMLElement& raw() const { return *element_; }

  // The only child of this name; a second one is a fault. nullopt where there is none.
  std::optional<XmlElement> child(const char* name) const;
  // As child(), and a missing one is a fault.
  std::optional<XmlElement> required_child(const char* name) const;
  XmlElement with_key(const tinyxml2::XMLElement& element, std::string key) const {
    return {element, std::move(key), *file_, *faults_};
  }

  bool has(const char* attribute) const { return element_->Attribute(attribute) != nullptr; }
  // Each reports a missing or wrong attribute.
  std::optional<std::string> name(const char* attribute) const;
  std::optional<double> number(const char* attribute, Range range) const;
  std::optional<Vec3> vector(const char* attribute, Range range) const;

  // Reports children that are not known but look like a known one: `<colision>` must not be passed
  // over as if it were somebody's extension.
  void report_misspelt(std::initializer_list<std::string_view> known) const;

 private:
  std::string attribute_key(const char* attribute) const { return key_ + "." + attribute; }

  const tinyxml2::XMLElement* element_;
  std::string key_;
  const std::string* file_;
  Faults* faults_;
};

// From <origin xyz="" rpy=""/>, a child that may be absent.
Pose read_origin(const XmlElement& element);

}  // namespace accord
