#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "base/in_quotes.h"
#include "base/outcome.h"
#include "geometry/vec2.h"
#include "io/json_value.h"

namespace seamwise {

/// Reading of JSON files: parsing with limits, and typed access whose errors contain the place and
/// a remedy. Only the first defect of a file is kept. Reading continues with zeros and empty values
/// in place of missing ones until a caller checks for a defect. The public readers return it.

inline constexpr double kMaxCoordinateCm = 1e4;

/// Converts to the default value of any type. Eigen's types are unsuitable: their default is not
/// initialised.
struct Nothing {
  template <class T>
  operator T() const {  // NOLINT(google-explicit-constructor)
    return T();
  }
};

/// A part of a file as the subject of a message ("tee.json: panel 'front', edge 3"), and the codes
/// of its defects.
struct Place {
  std::string name;
  Failure shape = Failure::kNotAGarment;  ///< wrong structure
  Failure number = Failure::kNumber;      ///< not a usable number
  int piece = -1;
  int seam = -1;
  bool keeps_unknown = false;              ///< unknown fields are accepted
  std::optional<Error>* defect = nullptr;  ///< first defect of the file, set by fail()

  Place in(const std::string& part) const;
  /// "<name> <text>."
  Error error(Failure code, const std::string& text) const;
  /// Stores error() if it is the file's first one.
  Nothing fail(Failure code, const std::string& text) const;
  bool failed() const { return defect->has_value(); }
};

/// A numbered part of `place`: "panel 'front', edge 3".
Place numbered(const Place& place, const char* what, std::size_t number);

/// A number for messages, with at most 6 significant digits.
std::string shown(double value);
/// A point in centimetres: "(12.4, 3.1) cm".
std::string shown(const Vec2& point);

/// Parses and checks a document, which is unusable after a defect. Defects: kTooLarge; kNotJson
/// with line and column; `place.shape` for a name that occurs twice in one object.
JsonDocument parseDocument(std::string_view text, const Place& place);

/// Returns `json`, which must be an object.
JsonValue object(const JsonValue& json, const Place& place, const std::string& what);
/// Returns the items of `json`, which must be a list.
std::vector<JsonValue> array(const JsonValue& json, const Place& place, const std::string& what);
/// Returns the member `key`, which must not be missing or null.
JsonValue need(const JsonValue& object, const char* key, const Place& place);

/// Parses one to `most` decimal digits; -1 for any other text.
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

/// Fails for a member of `object` outside `known`, which the message names, unless the place
/// accepts unknown fields.
void onlyKnown(const JsonValue& object, const Place& place,
               std::initializer_list<const char*> known);

/// Checks the optional `format` member, which is "<name>/<version>" with `version` at most. Returns
/// its version, or `version` for a file without the member.
int checkFormat(const JsonValue& document, const Place& place, const std::string& name,
                int version);

/// The error of another layer, as one sentence that starts with the file's name.
Error inFile(Error error, const std::string& file);

/// Parses a document and returns `read(document, place)`, or the first defect.
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
