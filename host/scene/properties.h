#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/diagnostics.h"
#include "scene/schema.h"

namespace laver::xml {

/// The properties of an object of a scene file, with defaults for those that are not given.
class Properties {
 public:
  /// Starts with the defaults. `offset` is the position of the object's tag.
  Properties(const ObjectRule& rule, std::size_t offset, Diagnostics& diagnostics);

  /// The index of a property in the rule's table, or the size of the table if there is none of that
  /// name.
  std::size_t find(std::string_view name) const;
  bool wasGiven(std::size_t index) const { return slots_[index].given; }
  void set(std::size_t index, Value value, std::size_t offset);
  /// Records that a property was given but could not be read.
  void spoil(std::size_t index, std::size_t offset);
  /// Reports missing required properties.
  void checkRequired() const;

  /// Values by name; name and type must be those of the rule. real() reports a number out of range.
  double real(std::string_view name) const;
  /// As real(), but an integer out of range is replaced by the default. `instead` overrides the
  /// value.
  std::int64_t integer(std::string_view name,
                       const std::optional<std::int64_t>& instead = {}) const;
  bool boolean(std::string_view name) const;
  glm::dvec3 triple(std::string_view name) const;
  glm::dmat4 transform(std::string_view name) const;
  const std::string& text(std::string_view name) const;
  /// All values that the file gives; reports numbers out of range.
  Values values() const;
  /// Whether there is a value: false for a required property that is missing or invalid.
  bool has(std::string_view name) const;

  /// Reports `message` at the property, or at the object if the property was not given.
  void error(std::string_view name, const std::string& message) const;

  /// A warning about the object.
  void note(const std::string& message) const;
  /// The same as a warning.
  void warning(std::string_view name, const std::string& message) const;

  std::size_t offset() const { return offset_; }
  const ObjectRule& rule() const { return rule_; }

 private:
  struct Slot {
    Value value;
    std::size_t offset;
    bool given = false;   // given in the file
    bool usable = false;  // has a value
  };
  const Slot& slot(std::string_view name) const { return slots_.at(find(name)); }
  bool checkRange(std::string_view name, const Value& value) const;

  const ObjectRule& rule_;
  std::size_t offset_;
  Diagnostics& diagnostics_;
  std::vector<Slot> slots_;
};

/// "camera \"perspective\"", for messages.
std::string nameOf(const ObjectRule& rule);

}  // namespace laver::xml
