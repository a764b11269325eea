#include <cmath>
#include <fstream>
#include <iterator>

#include "bench.h"
#include "io/problem_json.h"
#include "problem/placing_rules.h"

namespace seamwise::bench {
namespace {

std::string textOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("There is no file '" + file + "'.");
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string changedPrint(const std::string& text, double scale, double turn) {
  if (scale == 1 && turn == 0) return text;
  Json print = Json::parse(text);
  for (const char* basis : {"w1", "w2"}) {
    const double x = print[basis][0], y = print[basis][1];
    print[basis] = {scale * (std::cos(turn) * x - std::sin(turn) * y),
                    scale * (std::sin(turn) * x + std::cos(turn) * y)};
  }
  return print.dump();
}

}  // namespace

Problem problemOf(const Json& task, double print_scale, double print_turn) {
  ProblemTexts texts;
  texts.garment_name = task.at("garment");
  texts.garment = textOf(texts.garment_name);
  texts.print_name = task.at("print");
  texts.print = changedPrint(textOf(texts.print_name), print_scale, print_turn);
  texts.symmetry = task.value("symmetry", "auto");
  texts.options = task.contains("options") ? task["options"].dump() : "";
  const std::string method = task.value("method", "best");
  texts.method = method == "paper"  ? Method::kPaper
                 : method == "ws19" ? Method::kWs19
                                    : Method::kBest;
  texts.seed = task.value("seed", 1u);
  Problem problem = required(makeProblem(texts));
  problem.options.edge_length_cm = task.value("edgeLength", problem.options.edge_length_cm);
  if (task.value("evenSeams", false)) {
    for (Stitch& stitch : problem.garment.stitches) stitch.weight = 1;
    problem.options.matches.clear();
  }
  return problem;
}

MatchRules rulesOf(const Problem& problem) {
  return {pieceRules(problem), problem.options.matches, problem.options.continuous_only};
}

int trianglesOf(const Pattern& pattern) {
  std::size_t triangles = 0;
  for (const Piece& piece : pattern.pieces) triangles += piece.triangles.size();
  return static_cast<int>(triangles);
}

}  // namespace seamwise::bench
