#pragma once
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "io/garment_json.h"
#include "support/json.h"

namespace seamwise::testing {

/// Two rectangles, 10 cm wide and 20 cm high, sewn at both sides. Edges of both: 0 hem, 1 right
/// side, 2 top, 3 left side.
inline Json twoRectangles() {
  return Json::parse(R"({
    "pattern": {
      "panels": {
        "front": {
          "translation": [0, 100, 20], "rotation": [0, 0, 0],
          "vertices": [[0, 0], [10, 0], [10, 20], [0, 20]],
          "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]},
                    {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]},
        "back": {
          "translation": [0, 100, -20], "rotation": [0, 180, 0],
          "vertices": [[0, 0], [10, 0], [10, 20], [0, 20]],
          "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]},
                    {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]}},
      "stitches": [
        [{"panel": "front", "edge": 1}, {"panel": "back", "edge": 3}],
        [{"panel": "front", "edge": 3}, {"panel": "back", "edge": 1}]]},
    "properties": {"curvature_coords": "relative", "units_in_meter": 100}})");
}

/// Two right-angled triangles that mirror onto each other, neither in itself, sewn along a leg.
inline Json twoTriangles() {
  return Json::parse(R"({"pattern": {
    "panels": {
      "left": {"vertices": [[0, 0], [10, 0], [10, 20]], "translation": [-20, 0, 0],
        "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 0]}]},
      "right": {"vertices": [[0, 0], [10, 0], [0, 20]], "translation": [20, 0, 0],
        "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 0]}]}},
    "stitches": [[{"panel": "left", "edge": 1}, {"panel": "right", "edge": 2}]]},
    "properties": {"units_in_meter": 100}})");
}

inline Json& panelOf(Json& garment, const char* name) { return garment["pattern"]["panels"][name]; }

/// Reads a garment; the test fails if it is refused.
inline GarmentFile mustRead(const std::string& text) {
  Outcome<GarmentFile> file = readGarment(text, "shirt.json");
  if (!file.ok()) {
    ADD_FAILURE() << file.error().message;
    return {};
  }
  return std::move(file).value();
}
inline GarmentFile mustRead(const Json& document) { return mustRead(document.dump()); }

/// The error has this code, and its message contains all these words in one sentence.
template <class T>
void expectError(const Outcome<T>& outcome, Failure code,
                 std::initializer_list<const char*> words) {
  ASSERT_FALSE(outcome.ok());
  const Error& error = outcome.error();
  EXPECT_EQ(static_cast<int>(error.code), static_cast<int>(code)) << error.message;
  for (const char* word : words)
    EXPECT_NE(error.message.find(word), std::string::npos)
        << word << " is not in: " << error.message;
  ASSERT_FALSE(error.message.empty());
  EXPECT_EQ(error.message.back(), '.') << error.message;
}

inline void expectRefused(const std::string& text, Failure code,
                          std::initializer_list<const char*> words) {
  const Outcome<GarmentFile> file = readGarment(text, "shirt.json");
  expectError(file, code, words);
  expectError(file, code, {"shirt.json"});
}
inline void expectRefused(const Json& document, Failure code,
                          std::initializer_list<const char*> words) {
  expectRefused(document.dump(), code, words);
}

}  // namespace seamwise::testing
