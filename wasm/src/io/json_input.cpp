#include "io/json_input.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace seamwise {

void jsonMisused() { throw std::logic_error("a reader took a value for what it is not"); }

Place Place::in(const std::string& part) const {
  Place inner = *this;
  inner.name += (name.find(": ") == std::string::npos ? ": " : ", ") + part;
  return inner;
}

void Place::fail(Failure code, const std::string& text) const {
  throw InputError{Error{code, onOneLine(name) + " " + text + ".", piece, seam}};
}

Place numbered(const Place& place, const char* what, std::size_t number) {
  return place.in(std::string(what) + " " + std::to_string(number));
}

std::string shown(double value) {
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.6g", value);
  return digits;
}

std::string shown(const Vec2& point) {
  char digits[80];
  std::snprintf(digits, sizeof digits, "(%.1f, %.1f) cm", point.x(), point.y());
  return digits;
}

namespace {

std::string described(const Json& json) {
  switch (json.type()) {
    case Json::value_t::null:
      return "null";
    case Json::value_t::object:
      return "an object";
    case Json::value_t::array:
      return "a list";
    case Json::value_t::boolean:
      return json.get<bool>() ? "true" : "false";
    case Json::value_t::string:
      return "the text " + inQuotes(json.get_ref<const std::string&>());
    default:
      return "the number " + json.dump();
  }
}

}  // namespace

const Json& object(const Json& json, const Place& place, const std::string& what) {
  if (!json.is_object())
    place.fail(place.shape, "has " + described(json) + " as " + what + "; write an object {...}");
  return json;
}

const Json& array(const Json& json, const Place& place, const std::string& what) {
  if (!json.is_array())
    place.fail(place.shape, "has " + described(json) + " as " + what + "; write a list [...]");
  return json;
}

const Json* find(const Json& object, const char* key) {
  const auto it = object.find(key);
  return it == object.end() || it->is_null() ? nullptr : &*it;
}

const Json& need(const Json& object, const char* key, const Place& place) {
  const Json* member = find(object, key);
  if (!member) place.fail(place.shape, "has no '" + std::string(key) + "'; add it");
  return *member;
}

double number(const Json& json, const Place& place, const std::string& what, double limit) {
  if (!json.is_number())
    place.fail(place.number, "has " + described(json) + " as " + what + "; write a number");
  const double value = json.get<double>();
  if (!(std::abs(value) <= limit))
    place.fail(place.number, "has " + shown(value) + " as " + what + ", which is beyond " +
                                 shown(limit) + "; correct it");
  return value;
}

int integer(const Json& json, const Place& place, const std::string& what) {
  const double value = number(json, place, what, 1e9);
  if (value != std::floor(value))
    place.fail(place.number, "has " + shown(value) + " as " + what + "; write a whole number");
  return static_cast<int>(value);
}

bool boolean(const Json& json, const Place& place, const std::string& what) {
  if (!json.is_boolean())
    place.fail(place.shape, "has " + described(json) + " as " + what + "; write true or false");
  return json.get<bool>();
}

std::string text(const Json& json, const Place& place, const std::string& what) {
  if (!json.is_string())
    place.fail(place.shape, "has " + described(json) + " as " + what + "; write a text in quotes");
  return json.get<std::string>();
}

Vec2 point(const Json& json, const Place& place, const std::string& what, double scale,
           double limit) {
  if (!json.is_array() || json.size() != 2)
    place.fail(
        place.number,
        "has " + (json.is_array() ? "a list of " + std::to_string(json.size()) : described(json)) +
            " as " + what + "; write two numbers [x, y]");
  // Numbers that are merely too large are judged in centimetres, where the limit has a meaning.
  const Vec2 p(scale * number(json[0], place, "x of " + what, 1e300),
               scale * number(json[1], place, "y of " + what, 1e300));
  if (!(p.cwiseAbs().maxCoeff() <= limit))
    place.fail(place.number, "has " + shown(p) + " as " + what + ", which is beyond " +
                                 shown(limit) + " cm; correct it or the units");
  return p;
}

Polyline polyline(const Json& json, const Place& place, const std::string& what, double scale) {
  if (array(json, place, what).size() < 2)
    place.fail(place.shape,
               "has fewer than two points as " + what + "; write [[x, y], [x, y], ...]");
  Polyline line;
  for (const Json& p : json) line.push_back(point(p, place, "a point of " + what, scale));
  return line;
}

void onlyKnown(const Json& object, const Place& place, std::initializer_list<const char*> known) {
  if (place.keeps_unknown) return;
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    std::string names;
    for (const char* name : known) names += (names.empty() ? "" : ", ") + std::string(name);
    place.fail(place.shape, "has an unknown field " + inQuotes(key) + "; known are " + names);
  }
}

int checkFormat(const Json& document, const Place& place, const std::string& name, int version) {
  const Json* member = find(document, "format");
  if (!member) return version;
  const std::string format = text(*member, place, "'format'"), stem = name + "/";
  const std::string digits = format.substr(std::min(stem.size(), format.size()));
  if (format.compare(0, stem.size(), stem) != 0 || digits.empty() || digits.size() > 6 ||
      !std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }))
    place.fail(place.shape, "is of the format " + inQuotes(format) + "; a file of '" + stem +
                                std::to_string(version) + "' is needed here");
  const int found = std::stoi(digits);
  if (found > version)
    place.fail(place.shape, "is of the newer format " + inQuotes(format) +
                                ", this program reads up to '" + stem + std::to_string(version) +
                                "'; update the program");
  return found;
}

Error inFile(Error error, const std::string& file) {
  const bool ends = !error.message.empty() && error.message.back() == '.';
  error.message = onOneLine(file) + ": " + error.message + (ends ? "" : ".");
  return error;
}

}  // namespace seamwise
