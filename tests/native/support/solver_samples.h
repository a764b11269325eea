#pragma once
// The sample garments as files, and equivalent files of the same problem.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "io/problem_json.h"
#include "solve/solver.h"
#include "support/json.h"

namespace seamwise::testing {

/// A sample garment in its middle size, without data that depend on the panels' own coordinates or
/// on the order of its stitches, so that a test may move and reorder them.
inline Json sampleGarment(const std::string& name) {
  std::ifstream file(std::string(SEAMWISE_GARMENTS) + "/" + name + "-m.json");
  std::ostringstream text;
  text << file.rdbuf();
  Json garment = Json::parse(text.str());
  garment["pattern"].erase("panel_order");
  garment.erase("seams");
  for (Json& panel : garment["pattern"]["panels"])
    for (const char* field : {"translation", "rotation", "grain", "notches"}) panel.erase(field);
  return garment;
}

/// A print of the group; its shortest repeat is `size` cm.
inline Json samplePrint(const std::string& group, double size = 10) {
  const LatticeType type = findGroup(group)->lattice;
  Json w2 = {0, size};
  if (type == LatticeType::kOblique) w2 = {0.3 * size, 1.1 * size};
  if (type == LatticeType::kRectangular) w2 = {0, 1.2 * size};
  if (type == LatticeType::kRhombic) w2 = {0.6 * size, 0.8 * size};
  if (type == LatticeType::kHexagonal) w2 = {0.5 * size, std::sqrt(0.75) * size};
  return {{"group", group}, {"w1", {size, 0}}, {"w2", w2}};
}

/// Problem to solve, with everything that a test may reformulate. All seams count equally, so that
/// the cost of an answer is its total mismatch.
struct Task {
  Json garment, print;
  std::string symmetry = "auto";
  Json options = {{"visibility", "even"}};
  Method method = Method::kBest;
  std::uint32_t seed = 1;
};

inline Task task(const std::string& garment, const std::string& group) {
  Task t;
  t.garment = sampleGarment(garment), t.print = samplePrint(group);
  return t;
}

inline Problem problemOf(const Task& t) {
  ProblemTexts texts;
  texts.garment = t.garment.dump(), texts.garment_name = "garment.json";
  texts.print = t.print.dump(), texts.print_name = "print.json";
  texts.symmetry = t.symmetry, texts.symmetry_name = "symmetry.json";
  texts.options = t.options.dump(), texts.options_name = "options.json";
  texts.method = t.method, texts.seed = t.seed;
  Outcome<Problem> problem = makeProblem(texts);
  EXPECT_TRUE(problem.ok()) << problem.error().message;
  return std::move(problem).value();
}

/// The result of a solve of its own.
inline Result solvedAnew(const Task& t) {
  Outcome<Result> result = solve(problemOf(t));
  EXPECT_TRUE(result.ok()) << result.error().message;
  return std::move(result).value();
}

/// The result; the same problem is solved once for all tests of a program.
inline const Result& solved(const Task& t) {
  static std::map<std::string, Result> results;
  const Json key = {t.garment, t.print, t.symmetry, t.options, static_cast<int>(t.method), t.seed};
  const std::string text = key.dump();
  const auto known = results.find(text);
  return known != results.end() ? known->second
                                : results.emplace(text, solvedAnew(t)).first->second;
}

inline Json& panelsOf(Json& garment) { return garment["pattern"]["panels"]; }

/// Maps the vertices of every panel; curves follow, because they are relative to their edges.
inline void moveVertices(Json& garment, const std::function<Vec2(int panel, const Vec2&)>& map) {
  int number = 0;
  for (Json& panel : panelsOf(garment)) {
    for (Json& v : panel["vertices"]) {
      const Vec2 p = map(number, Vec2(v[0], v[1]));
      v = {p.x(), p.y()};
    }
    ++number;
  }
}

/// Mirrors the garment: negates x and reverses every outline, so that its panels show their faces
/// again.
inline void mirrorGarment(Json& garment) {
  moveVertices(garment, [](int, const Vec2& p) { return Vec2(-p.x(), p.y()); });
  for (Json& panel : panelsOf(garment)) {
    Json edges = Json::array();
    for (auto edge = panel["edges"].rbegin(); edge != panel["edges"].rend(); ++edge) {
      Json reversed = *edge;
      std::swap(reversed["endpoints"][0], reversed["endpoints"][1]);
      if (reversed.contains("curvature")) {
        // heights keep their sign: the edge's left side is mirrored, and the edge is reversed
        Json& params = reversed["curvature"]["params"];
        std::reverse(params.begin(), params.end());
        for (Json& control : params) control[0] = 1 - control[0].get<double>();
      }
      edges.push_back(reversed);
    }
    panel["edges"] = edges;
  }
  for (Json& stitch : garment["pattern"]["stitches"])
    for (Json& side : stitch) {
      const int count = static_cast<int>(panelsOf(garment)[side["panel"]]["edges"].size());
      side["edge"] = count - 1 - side["edge"].get<int>();
    }
}

/// Gives every panel another name, in another alphabetical order.
inline void renamePanels(Json& garment) {
  std::map<std::string, std::string> names;
  Json renamed = Json::object();
  int number = 0;
  for (const auto& [name, panel] : panelsOf(garment).items()) {
    names[name] = std::string(1, static_cast<char>('z' - number++)) + " " + name;
    renamed[names[name]] = panel;
  }
  panelsOf(garment) = renamed;
  for (Json& stitch : garment["pattern"]["stitches"])
    for (Json& side : stitch) side["panel"] = names[side["panel"]];
}

/// Lists panels and stitches in reverse order.
inline void reorder(Json& garment) {
  std::vector<std::pair<std::string, Json>> panels;
  for (const auto& [name, panel] : panelsOf(garment).items()) panels.emplace_back(name, panel);
  Json reversed = Json::object();
  for (auto p = panels.rbegin(); p != panels.rend(); ++p) reversed[p->first] = p->second;
  panelsOf(garment) = reversed;
  Json& stitches = garment["pattern"]["stitches"];
  std::reverse(stitches.begin(), stitches.end());
}

}  // namespace seamwise::testing
