#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "base/in_quotes.h"
#include "base/outcome.h"
#include "geometry/vec2.h"
#include "io/json_value.h"

namespace seamwise {

/// Reading JSON files: parsing with limits, and typed access whose errors say where and what to do.
/// A defect is kept, the first of a file only, and reading goes on with zeros and nothing in place
/// of what is missing until somebody looks whether there is one; the public readers return it.

inline constexpr double kMaxCoordinateCm = 1e4;

/// The default value of any type but Eigen's, whose default is not initialised.
struct Nothing {
  template <class T>
  operator T() const {  // NOLINT(google-explicit-constructor)
    return T();
  }
};

/// What is being read, as the subject of a sentence ("tee.json: panel 'front', edge 3"), and the
/// codes under which its defects are reported.
struct Place {
  std::string name;
  Failure shape = Failure::kNotAGarment;  ///< wrong structure
  Failure number = Failure::kNumber;      ///< something that is not a usable number
  int piece = -1;
  int seam = -1;
  bool keeps_unknown = false;              ///< unknown fields are left alone, not refused
  std::optional<Error>* defect = nullptr;  ///< of the file, where fail() keeps it

  Place in(const std::string& part) const;
  /// "<name> <text>."
  Error error(Failure code, const std::string& text) const;
  /// Keeps error(), unless it is not the first.
  Nothing fail(Failure code, const std::string& text) const;
  bool failed() const { return defect->has_value(); }
};

/// `place`, numbered: "panel 'front', edge 3".
Place numbered(const Place& place, const char* what, std::size_t number);

/// A number as people write it: at most 6 significant digits.
std::string shown(double value);
/// A point in centimetres: "(12.4, 3.1) cm".
std::string shown(const Vec2& point);

/// The document, of no use after a defect. Defects: kTooLarge; kNotJson with line and column;
/// `place.shape` for a name that occurs twice in one object.
JsonDocument parseDocument(std::string_view text, const Place& place);

/// `json`, which must be an object.
JsonValue object(const JsonValue& json, const Place& place, const std::string& what);
/// The items of `json`, which must be a list.
std::vector<JsonValue> array(const JsonValue& json, const Place& place, const std::string& what);
/// The member, which must not be missing or null.
JsonValue need(const JsonValue& object, const char* key, const Place& place);

/// The number that at most `most` digits make; -1 for any other text.
int countOf(std::string_view digits, std::size_t most);

/// A finite number of magnitude at most `limit`.
double number(const JsonValue& json, const Place& place, const std::string& what, double limit);
/// A whole number (3 or 3.0) of magnitude at most 1e9.
int integer(const JsonValue& json, const Place& place, const std::string& what);
bool boolean(const JsonValue& json, const Place& place, const std::string& what);
std::string text(const JsonValue& json, const Place& place, const std::string& what);
/// [x, y], each of magnitude at most `limit`, times `scale`.
Vec2 point(const JsonValue& json, const Place& place, const std::string& what, double scale = 1,
           double limit = kMaxCoordinateCm);
/// [[x, y], ...], at least two points.
Polyline polyline(const JsonValue& json, const Place& place, const std::string& what,
                  double scale = 1);

/// Fails when `object` has a member that is not among `known`, naming it, unless the place keeps
/// such.
void onlyKnown(const JsonValue& object, const Place& place,
               std::initializer_list<const char*> known);

/// Checks a `format` member, if there is one: `name`/`version`. Returns the version found, or
/// `version` when the file names none.
int checkFormat(const JsonValue& document, const Place& place, const std::string& name,
                int version);

/// The error of another layer, as one sentence that starts with the file's name.
Error inFile(Error error, const std::string& file);

/// What `read` makes of a document and its place, unless there is a defect.
template <class T, class Read>
Outcome<T> readDocument(std::string_view text, Place place, Read read) {
  std::optional<Error> defect;
  place.defect = &defect;
  const JsonDocument document = parseDocument(text, place);
  if (defect) return *defect;
  Outcome<T> made = read(JsonValue(document), place);
  if (defect) return *defect;
  return made;
}

}  // namespace seamwise
