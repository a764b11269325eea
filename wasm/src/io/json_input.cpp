#include "io/json_input.h"

#include <algorithm>
#include <cmath>

#include "base/decimal.h"

namespace seamwise {

Place Place::in(const std::string& part) const {
  Place inner = *this;
  inner.name += (name.find(": ") == std::string::npos ? ": " : ", ") + part;
  return inner;
}

Error Place::error(Failure code, const std::string& text) const {
  return {code, onOneLine(name) + " " + text + ".", piece, seam};
}

Nothing Place::fail(Failure code, const std::string& text) const {
  if (!failed()) *defect = error(code, text);
  return {};
}

Place numbered(const Place& place, const char* what, std::size_t number) {
  return place.in(std::string(what) + " " + decimal(number));
}

std::string shown(double value) { return significant(value, 6); }

std::string shown(const Vec2& point) {
  return "(" + fixed(point.x(), 1) + ", " + fixed(point.y(), 1) + ") cm";
}

namespace {

std::string described(const JsonValue& json) {
  switch (json.kind()) {
    case JsonKind::kNull:
      return "null";
    case JsonKind::kFalse:
      return "false";
    case JsonKind::kTrue:
      return "true";
    case JsonKind::kNumber:
      return "the number " + significant(json.number(), 15);
    case JsonKind::kText:
      return "the text " + inQuotes(json.text());
    case JsonKind::kList:
      return "a list";
    case JsonKind::kObject:
      break;
  }
  return "an object";
}

}  // namespace

JsonValue object(const JsonValue& json, const Place& place, const std::string& what) {
  if (!json.isObject())
    return place.fail(place.shape,
                      "has " + described(json) + " as " + what + "; write an object {...}");
  return json;
}

std::vector<JsonValue> array(const JsonValue& json, const Place& place, const std::string& what) {
  if (!json.isList())
    return place.fail(place.shape,
                      "has " + described(json) + " as " + what + "; write a list [...]");
  return json.items();
}

JsonValue need(const JsonValue& object, const char* key, const Place& place) {
  const JsonValue member = object.find(key);
  if (!member) return place.fail(place.shape, "has no '" + std::string(key) + "'; add it");
  return member;
}

int countOf(std::string_view digits, std::size_t most) {
  if (digits.empty() || digits.size() > most) return -1;
  int count = 0;
  for (const char digit : digits) {
    if (digit < '0' || digit > '9') return -1;
    count = 10 * count + (digit - '0');
  }
  return count;
}

double number(const JsonValue& json, const Place& place, const std::string& what, double limit) {
  if (!json.isNumber())
    return place.fail(place.number, "has " + described(json) + " as " + what + "; write a number");
  const double value = json.number();
  if (!(std::abs(value) <= limit))
    return place.fail(place.number, "has " + shown(value) + " as " + what + ", which is beyond " +
                                        shown(limit) + "; correct it");
  return value;
}

int integer(const JsonValue& json, const Place& place, const std::string& what) {
  const double value = number(json, place, what, 1e9);
  if (value != std::floor(value))
    return place.fail(place.number,
                      "has " + shown(value) + " as " + what + "; write a whole number");
  return static_cast<int>(value);
}

bool boolean(const JsonValue& json, const Place& place, const std::string& what) {
  if (!json.isBoolean())
    return place.fail(place.shape,
                      "has " + described(json) + " as " + what + "; write true or false");
  return json.isTrue();
}

std::string text(const JsonValue& json, const Place& place, const std::string& what) {
  if (!json.isText())
    return place.fail(place.shape,
                      "has " + described(json) + " as " + what + "; write a text in quotes");
  return json.text();
}

Vec2 point(const JsonValue& json, const Place& place, const std::string& what, double scale,
           double limit) {
  if (!json.isList() || json.size() != 2)
    place.fail(place.number,
               "has " + (json.isList() ? "a list of " + decimal(json.size()) : described(json)) +
                   " as " + what + "; write two numbers [x, y]");
  // The limit applies to centimetres, so the raw number has only a bound that keeps it finite.
  const Vec2 p(scale * number(json[0], place, "x of " + what, 1e300),
               scale * number(json[1], place, "y of " + what, 1e300));
  if (p.cwiseAbs().maxCoeff() <= limit) return p;
  place.fail(place.number, "has " + shown(p) + " as " + what + ", which is beyond " + shown(limit) +
                               " cm; correct it or the units");
  return Vec2::Zero();
}

Polyline polyline(const JsonValue& json, const Place& place, const std::string& what,
                  double scale) {
  const std::vector<JsonValue> points = array(json, place, what);
  if (points.size() < 2)
    return place.fail(place.shape,
                      "has fewer than two points as " + what + "; write [[x, y], [x, y], ...]");
  Polyline line;
  for (const JsonValue& p : points) line.push_back(point(p, place, "a point of " + what, scale));
  return line;
}

void onlyKnown(const JsonValue& object, const Place& place,
               std::initializer_list<const char*> known) {
  if (place.keeps_unknown) return;
  for (const auto& [key, value] : object.members()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    std::string names;
    for (const char* name : known) names += (names.empty() ? "" : ", ") + std::string(name);
    place.fail(place.shape, "has an unknown field " + inQuotes(key) + "; known are " + names);
    return;
  }
}

int checkFormat(const JsonValue& document, const Place& place, const std::string& name,
                int version) {
  const JsonValue member = document.find("format");
  if (!member) return version;
  const std::string format = text(member, place, "'format'"), stem = name + "/";
  const int found = countOf(format.substr(std::min(stem.size(), format.size())), 6);
  if (format.compare(0, stem.size(), stem) != 0 || found < 0)
    return place.fail(place.shape, "is of the format " + inQuotes(format) + "; a file of '" + stem +
                                       decimal(version) + "' is needed here");
  if (found > version)
    return place.fail(place.shape, "is of the newer format " + inQuotes(format) +
                                       ", this program reads up to '" + stem + decimal(version) +
                                       "'; update the program");
  return found;
}

Error inFile(Error error, const std::string& file) {
  const bool ends = !error.message.empty() && error.message.back() == '.';
  error.message = onOneLine(file) + ": " + error.message + (ends ? "" : ".");
  return error;
}

}  // namespace seamwise
