// Random problems (libFuzzer): no file may crash the program, make it read out of bounds, or make
// it run forever. An input is up to four JSON texts: garment, print, options, symmetries. They are
// separated by a byte that none of them contains.
#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "io/problem_json.h"
#include "io/result_json.h"
#include "solve/solver.h"

namespace seamwise {
namespace {

using Json = nlohmann::json;

constexpr char kSeparator = '\x1E';
constexpr std::size_t kTexts = 4;
/// Larger problems are read but not solved: they would only take longer.
constexpr std::size_t kMostEdges = 60;
/// Enough steps to reach both search and shaping.
constexpr int kMostSteps = 30;

using Texts = std::array<std::string, kTexts>;

Texts textsIn(std::string_view input) {
  Texts texts;
  for (std::string& text : texts) {
    const std::size_t end = std::min(input.find(kSeparator), input.size());
    text = input.substr(0, end);
    input.remove_prefix(std::min(end + 1, input.size()));
  }
  return texts;
}

std::string joined(const Texts& texts) {
  std::string input = texts[0];
  for (std::size_t k = 1; k < kTexts; ++k) input += kSeparator + texts[k];
  return input;
}

void solveSome(Problem problem) {
  std::size_t edges = 0;
  for (const Panel& panel : problem.garment.panels) edges += panel.edges.size();
  if (edges > kMostEdges) return;
  SolverSetup setup(std::move(problem));
  while (setup.advance()) {
  }
  Outcome<Solver> solver = setup.take();
  if (!solver.ok()) return;
  for (int step = 0; step < kMostSteps && solver.value().advance(1); ++step) {
  }
}

/// Picks any value of a document.
Json* anyOf(Json& json, std::mt19937& random) {
  Json* at = &json;
  while (at->is_structured() && !at->empty() && random() % 8 != 0)
    at = &*std::next(at->begin(), static_cast<std::ptrdiff_t>(random() % at->size()));
  return at;
}

/// Changes one value, as an editor or a program that writes such files might.
void change(Json& json, std::mt19937& random) {
  static const std::vector<Json> kOdd = {
      nullptr, true, 0,     1,  -1,     0.5,    1e-9,          -1e-3,         10,
      9999,    1e9,  1e300, "", "auto", "none", Json::array(), Json::object()};
  Json& value = *anyOf(json, random);
  switch (random() % 5) {
    case 0:
      value = kOdd[random() % kOdd.size()];
      break;
    case 1:
      value = Json(*anyOf(json, random));  // a copy: it may be a part of `value`
      break;
    case 2:
      if (value.is_number()) value = value.get<double>() * (1 + 0.2 * (random() % 11 - 5.0));
      break;
    case 3:
      if (value.is_structured() && !value.empty())
        value.erase(std::next(value.begin(), static_cast<std::ptrdiff_t>(random() % value.size())));
      break;
    default:
      if (value.is_array() && !value.empty()) value.push_back(Json(value[random() % value.size()]));
  }
}

}  // namespace
}  // namespace seamwise

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace seamwise;
  auto [garment, print, options, symmetry] = textsIn({reinterpret_cast<const char*>(data), size});
  Outcome<Problem> problem =
      makeProblem({.garment = std::move(garment),
                   .garment_name = "garment",
                   .print = std::move(print),
                   .print_name = "print",
                   .symmetry = symmetry.empty() ? "auto" : std::move(symmetry),
                   .symmetry_name = "symmetry",
                   .options = std::move(options),
                   .options_name = "options"});
  if (problem.ok()) solveSome(std::move(problem.value()));
  return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

/// Usually changes one value. Random bytes alone are hardly ever JSON, and such inputs soon become
/// all alike.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  using namespace seamwise;
  std::mt19937 random(seed);
  if (random() % 5 == 0) return LLVMFuzzerMutate(data, size, most);
  Texts texts = textsIn({reinterpret_cast<const char*>(data), size});
  std::string& text = texts[random() % 2 == 0 ? 0 : random() % kTexts];
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return LLVMFuzzerMutate(data, size, most);
  change(json, random);
  text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  const std::string input = joined(texts);
  if (input.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::copy(input.begin(), input.end(), data);
  return input.size();
}
