#include <gtest/gtest.h>

#include <cmath>

#include "garment_texts.h"
#include "io/options_json.h"
#include "io/print_json.h"
#include "io/problem_json.h"
#include "io/symmetry_json.h"

namespace seamwise {
namespace {

using testing::expectError;
using testing::mustRead;
using testing::panelOf;
using testing::twoRectangles;

constexpr const char* kMirrored = R"({"group": "pm", "w1": [10, 0], "w2": [0, 12]})";
constexpr const char* kGlides = R"({"group": "pg", "w1": [10, 0], "w2": [0, 12]})";
constexpr const char* kPlainRepeat = R"({"group": "p1", "w1": [10, 0], "w2": [3, 12]})";

/// Two rectangles that are mirror images of each other and of themselves.
ProblemTexts texts(const char* print = kMirrored, const char* symmetry = "auto",
                   const char* options = "") {
  ProblemTexts t;
  t.garment = twoRectangles().dump();
  t.garment_name = "shirt.json";
  t.print = print;
  t.print_name = "daisy.json";
  t.symmetry = symmetry;
  t.symmetry_name = "mirror.json";
  t.options = options;
  t.options_name = "options.json";
  return t;
}

/// Two right-angled triangles that mirror onto each other, none in itself, sewn along a leg.
Json twoTriangles() {
  return Json::parse(R"({"pattern": {
    "panels": {
      "left": {"vertices": [[0, 0], [10, 0], [10, 20]], "translation": [-20, 0, 0],
        "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 0]}]},
      "right": {"vertices": [[0, 0], [10, 0], [0, 20]], "translation": [20, 0, 0],
        "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 0]}]}},
    "stitches": [[{"panel": "left", "edge": 1}, {"panel": "right", "edge": 2}]]},
    "properties": {"units_in_meter": 100}})");
}

Outcome<SolveOptions> options(const std::string& text) {
  return readOptions(text, "options.json", mustRead(twoRectangles()).garment);
}

// --- print ---------------------------------------------------------------------------------------

TEST(PrintFile, IsReadWithItsGroupAndLattice) {
  const auto print = readPrint(
      R"({"format": "seamwise-print/1", "group": "pmg", "w1": [6, 0], "w2": [0, 8], "oneWay": true,
          "image": "daisy.png", "cell": "rectangular", "fabric": {"usableWidthCm": 140}})",
      "daisy.json");
  ASSERT_TRUE(print.ok()) << print.error().message;
  EXPECT_EQ(print.value().group.data().name, "pmg");
  EXPECT_EQ(print.value().group.w2(), Vec2(0, 8));
  EXPECT_TRUE(print.value().one_way);
}

TEST(PrintFile, ThatIsUnusableNamesTheFileAndTheField) {
  const auto refuse = [](const char* text, Failure code, std::initializer_list<const char*> words) {
    const auto print = readPrint(text, "daisy.json");
    expectError(print, code, {"daisy.json"});
    expectError(print, code, words);
  };
  refuse("", Failure::kNotJson, {"is empty"});
  refuse("[]", Failure::kNotAPrint, {"a list"});
  refuse(R"({"w1": [1, 0], "w2": [0, 1]})", Failure::kNotAPrint, {"'group'"});
  refuse(R"({"group": "p1", "w1": [1, 0]})", Failure::kNotAPrint, {"'w2'"});
  refuse(R"({"group": "p1", "w1": [1, "0"], "w2": [0, 1]})", Failure::kNotAPrint,
         {"'w1'", "the text '0'"});
  refuse(R"({"group": "p5", "w1": [1, 0], "w2": [0, 1]})", Failure::kGroupUnknown, {"p5"});
  refuse(R"({"group": "p4", "w1": [1, 0], "w2": [0, 2]})", Failure::kLattice, {"p4"});
  refuse(R"({"group": "p1", "w1": [1, 0], "w2": [0, 1], "oneWay": 1})", Failure::kNotAPrint,
         {"'oneWay'", "true or false"});
  refuse(R"({"group": "p1", "w1": [1, 0], "w2": [0, 1], "cell": "round"})", Failure::kNotAPrint,
         {"'round'"});
  refuse(R"({"format": "seamwise-print/9", "group": "p1"})", Failure::kNotAPrint,
         {"update the program"});
}

// --- symmetries ----------------------------------------------------------------------------------

TEST(SymmetryFile, IsReadInAllItsKinds) {
  const auto requests = readSymmetries(R"({"symmetries": [
      {"kind": "piece", "piece": "front", "axis": [[0, 10], [0, 60]]},
      {"kind": "piece", "piece": "back", "seams": [3, 5]},
      {"kind": "piece", "piece": "yoke"},
      {"kind": "pair", "pieces": ["left", "right"]}]})",
                                       "mirror.json");
  ASSERT_TRUE(requests.ok()) << requests.error().message;
  ASSERT_EQ(requests.value().size(), 4u);
  EXPECT_EQ(std::get<AxisRequest>(requests.value()[0]).to, Vec2(0, 60));
  EXPECT_EQ(std::get<EdgesRequest>(requests.value()[1]).second, 5);
  EXPECT_EQ(std::get<PieceRequest>(requests.value()[2]).piece, "yoke");
  EXPECT_EQ(std::get<PairRequest>(requests.value()[3]).second, "right");
}

TEST(SymmetryFile, ThatIsMalformedNamesTheEntry) {
  const auto refuse = [](const std::string& entry, std::initializer_list<const char*> words) {
    const auto requests = readSymmetries(
        R"({"symmetries": [{"kind": "piece", "piece": "ok"}, )" + entry + "]}", "mirror.json");
    expectError(requests, Failure::kSymmetryMalformed, {"mirror.json: symmetry 1"});
    expectError(requests, Failure::kSymmetryMalformed, words);
  };
  refuse(R"({"kind": "triple"})", {"'triple'", "piece or pair"});
  refuse(R"({"kind": "piece"})", {"'piece'"});
  refuse(R"({"piece": "front"})", {"'kind'"});
  refuse(R"({"kind": "pair", "pieces": ["a"]})", {"'pieces'"});
  refuse(R"({"kind": "pair", "pieces": ["a", "a"]})", {"'a' with itself"});
  refuse(R"({"kind": "piece", "piece": "a", "axis": [[0, 0], [0, 0]]})", {"two distinct points"});
  refuse(R"({"kind": "piece", "piece": "a", "axis": [[0, 0], [0, 1]], "seams": [1, 2]})", {"both"});
  refuse(R"({"kind": "piece", "piece": "a", "seams": [1, 2.5]})", {"whole number"});
  refuse(R"({"kind": "piece", "piece": "a", "axes": []})", {"unknown field 'axes'"});
  expectError(readSymmetries("{}", "mirror.json"), Failure::kSymmetryMalformed, {"'symmetries'"});
}

TEST(SymmetryFile, ThatWasWrittenReadsBackAsTheSameSymmetries) {
  for (const Json& document : {twoRectangles(), twoTriangles()}) {
    const Garment garment = mustRead(document).garment;
    const auto found = detectSymmetries(garment);
    ASSERT_FALSE(found.empty());
    const auto requests = readSymmetries(writeSymmetries(garment, found), "found.json");
    ASSERT_TRUE(requests.ok()) << requests.error().message;
    const auto again = registerSymmetries(garment, requests.value());
    ASSERT_TRUE(again.ok()) << again.error().message;
    ASSERT_EQ(again.value().size(), found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(again.value()[i].pieces[1], found[i].pieces[1]);
      EXPECT_LT((again.value()[i].map({3, 4}) - found[i].map({3, 4})).norm(), 1e-5);
    }
  }
}

TEST(SymmetryFile, StatesTheAxisInTheFrameOfTheInputPanel) {
  Json document = twoRectangles();
  Json& front = panelOf(document, "front");
  front["edges"] = Json::parse(
      R"([{"endpoints": [0, 3]}, {"endpoints": [3, 2]}, {"endpoints": [2, 1]}, {"endpoints": [1, 0]}])");
  const Garment garment = mustRead(document).garment;
  ASSERT_TRUE(garment.panels[0].mirrored_from_input);
  const BodySymmetry upright{{0, 0}, RigidMotion::reflection({-5, 0}, {-5, 1}), 0};
  const Json written = Json::parse(writeSymmetries(garment, {upright}));
  const Json& axis = written["symmetries"][0]["axis"];
  EXPECT_NEAR(axis[0][0].get<double>(), 5, 1e-9);
  EXPECT_NEAR(axis[1][0].get<double>(), 5, 1e-9);
  EXPECT_NEAR(std::abs(axis[0][1].get<double>() - axis[1][1].get<double>()), 20, 1e-9);
}

// --- options -------------------------------------------------------------------------------------

TEST(OptionsFile, KeepsTheDefaultsOfWhatItLeavesOut) {
  const auto read = options("{}");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read.value().max_change_cm, 1.0);
  EXPECT_FALSE(read.value().alpha.has_value());
  EXPECT_TRUE(read.value().problem().empty());
}

TEST(OptionsFile, IsReadInAllItsFields) {
  const auto read = options(R"({
      "maxChangeCm": 0.5, "alpha": 2, "edgeLengthCm": 0.8, "continuousOnly": true,
      "averageSeamShapes": false,
      "grain": {"default": "bias", "toleranceDeg": 9,
                "pieces": {"front": "on", "back": {"lock": "free", "toleranceDeg": 18}}},
      "pins": {"back": {"angle": 0.25, "translation": [1, 2]}},
      "weights": {"1": 0.5}, "unmatched": [0], "plain": ["back"],
      "matches": [{"a": {"piece": "front", "line": [[1, 0], [1, 4], [1, 10]]},
                   "b": {"piece": "back", "line": [[9, 0], [9, 10]]}, "weight": 3}]})");
  ASSERT_TRUE(read.ok()) << read.error().message;
  const SolveOptions& o = read.value();
  EXPECT_EQ(o.max_change_cm, 0.5);
  EXPECT_EQ(o.alpha, 2);
  EXPECT_EQ(o.edge_length_cm, 0.8);
  EXPECT_TRUE(o.continuous_only);
  EXPECT_EQ(o.average_seam_shapes, false);
  EXPECT_EQ(o.grain.lock, GrainLock::kBias);
  EXPECT_EQ(o.piece_grain.at(0).lock, GrainLock::kOn);
  EXPECT_NEAR(o.piece_grain.at(0).tolerance, kPi / 20, 1e-12);
  EXPECT_NEAR(o.piece_grain.at(1).tolerance, kPi / 10, 1e-12);
  EXPECT_EQ(o.pins.at(1).angle, 0.25);
  EXPECT_EQ(o.pins.at(1).translation, Vec2(1, 2));
  EXPECT_EQ(o.weights.at(1), 0.5);
  EXPECT_EQ(o.unmatched, std::vector<int>{0});
  EXPECT_EQ(o.plain, std::vector<int>{1});
  ASSERT_EQ(o.matches.size(), 1u);
  EXPECT_EQ(o.matches[0].weight, 3);
  ASSERT_EQ(o.matches[0].a.size(), 11u);  // 10 cm in steps of at most 1 cm, on both sides
  ASSERT_EQ(o.matches[0].b.size(), 11u);
  EXPECT_LT((o.matches[0].a[7] - Vec2(1, 7)).norm(), 1e-12);
}

TEST(OptionsFile, ThatIsUnusableNamesTheField) {
  const auto refuse = [](const char* text, std::initializer_list<const char*> words) {
    const auto read = options(text);
    expectError(read, Failure::kOptions, {"options.json"});
    expectError(read, Failure::kOptions, words);
  };
  refuse(R"({"maxChange": 1})", {"unknown field 'maxChange'", "maxChangeCm"});
  refuse(R"({"maxChangeCm": -1})", {"maxChangeCm"});
  refuse(R"({"maxChangeCm": "1"})", {"'maxChangeCm'", "the text '1'"});
  refuse(R"({"edgeLengthCm": 2})", {"edgeLengthCm", "1.05"});
  refuse(R"({"edgeLengthCm": 0})", {"edgeLengthCm"});
  refuse(R"({"alpha": 0})", {"alpha"});
  refuse(R"({"continuousOnly": "yes"})", {"'continuousOnly'"});
  refuse(R"({"grain": {"lock": "on"}})", {"unknown field 'lock'"});
  refuse(R"({"grain": {"default": "straight"}})", {"'straight'", "free, on or bias"});
  refuse(R"({"grain": {"toleranceDeg": 91}})", {"toleranceDeg"});
  refuse(R"({"grain": {"pieces": {"sleeve": "on"}}})", {"'sleeve'", "grain.pieces"});
  refuse(R"({"pins": {"sleeve": {"angle": 0, "translation": [0, 0]}}})", {"'sleeve'", "'pins'"});
  refuse(R"({"pins": {"front": {"angle": 0}}})", {"'front'", "'translation'"});
  refuse(R"({"weights": {"2": 1}})", {"seam 2", "'weights'"});
  refuse(R"({"weights": {"first": 1}})", {"'first'", "'weights'"});
  refuse(R"({"weights": {"1": -1}})", {"weights", "seam 1"});
  refuse(R"({"unmatched": [-1]})", {"seam -1", "'unmatched'"});
  refuse(R"({"plain": ["lining"]})", {"'lining'", "'plain'"});
  refuse(R"({"matches": [{"a": {"piece": "front", "line": [[0, 0], [0, 5]]}}]})",
         {"match 0", "'b'"});
  refuse(R"({"matches": [{"a": {"piece": "cuff", "line": [[0, 0], [0, 5]]}, "b": 1}]})",
         {"match 0, side a", "'cuff'"});
  refuse(R"({"matches": [{"a": {"piece": "front", "line": [[0, 0], [0, 0]]}, "b": 1}]})",
         {"match 0, side a", "shorter than"});
}

TEST(SolveOptions, FindsWhatNoFileCouldHold) {
  SolveOptions o;
  EXPECT_EQ(o.problem(), "");
  o.max_change_cm = NAN;
  EXPECT_NE(o.problem().find("maxChangeCm"), std::string::npos);
  o = {};
  o.pins[0].angle = NAN;
  EXPECT_NE(o.problem().find("pins"), std::string::npos);
  o = {};
  o.weights[0] = INFINITY;
  EXPECT_NE(o.problem().find("weights"), std::string::npos);
  o = {};
  o.matches.push_back({0, 1, {{0, 0}, {1, 1}}, {{0, 0}}, 1.0});
  EXPECT_NE(o.problem().find("matches"), std::string::npos);
}

// --- problem -------------------------------------------------------------------------------------

TEST(ProblemFromFiles, ImposesTheSymmetriesItFindsWhenThePrintCarriesThem) {
  const auto problem = makeProblem(texts());
  ASSERT_TRUE(problem.ok()) << problem.error().message;
  EXPECT_FALSE(problem.value().imposed.empty());
  EXPECT_EQ(problem.value().imposed.size(), problem.value().known.size());
  EXPECT_TRUE(problem.value().notes.empty());
}

TEST(ProblemFromFiles, DropsWhatThePrintCannotCarryAndSaysSo) {
  ProblemTexts t = texts(kPlainRepeat);
  t.garment = twoTriangles().dump();
  const auto problem = makeProblem(t);
  ASSERT_TRUE(problem.ok()) << problem.error().message;
  EXPECT_TRUE(problem.value().imposed.empty());
  EXPECT_EQ(problem.value().known.size(), 1u);
  ASSERT_EQ(problem.value().notes.size(), 1u);
  for (const char* word : {"p1", "'left' and 'right'", "pg"})
    EXPECT_NE(problem.value().notes[0].find(word), std::string::npos) << problem.value().notes[0];
}

TEST(ProblemFromFiles, CarriesPairsButNoSinglePiecesInAPrintOfGlides) {
  ProblemTexts t = texts(kGlides);
  t.garment = twoTriangles().dump();
  const auto pair = makeProblem(t);
  ASSERT_TRUE(pair.ok()) << pair.error().message;
  EXPECT_EQ(pair.value().imposed.size(), 1u);

  const auto single =
      makeProblem(texts(kGlides, R"({"symmetries": [{"kind": "piece", "piece": "front"}]})"));
  expectError(single, Failure::kSymmetryGroup, {"mirror.json", "'front'", "pg", "pmm"});
  EXPECT_EQ(single.error().piece, 0);
}

TEST(ProblemFromFiles, RefusesAPairThatThePrintCannotCarry) {
  ProblemTexts t =
      texts(kPlainRepeat, R"({"symmetries": [{"kind": "pair", "pieces": ["left", "right"]}]})");
  t.garment = twoTriangles().dump();
  expectError(makeProblem(t), Failure::kSymmetryGroup, {"'left' and 'right'", "p1", "pg"});
}

TEST(ProblemFromFiles, ImposesNothingWhenToldSoButKeepsWhatItKnows) {
  const auto problem = makeProblem(texts(kMirrored, "none"));
  ASSERT_TRUE(problem.ok()) << problem.error().message;
  EXPECT_TRUE(problem.value().imposed.empty());
  EXPECT_FALSE(problem.value().known.empty());
}

TEST(ProblemFromFiles, ImposesWhatIsAskedForAndKnowsTheRest) {
  const auto problem =
      makeProblem(texts(kMirrored, R"({"symmetries": [{"kind": "piece", "piece": "back"}]})"));
  ASSERT_TRUE(problem.ok()) << problem.error().message;
  ASSERT_EQ(problem.value().imposed.size(), 1u);
  EXPECT_EQ(problem.value().imposed[0].pieces[0], 1);
  EXPECT_TRUE(problem.value().imposed[0].single());
  for (const BodySymmetry& known : problem.value().known)
    EXPECT_TRUE(known.pieces[0] == 0 ? known.single() : known.pieces[0] == 1);
}

TEST(ProblemFromFiles, PrefersTheSymmetriesThatTheGarmentStates) {
  ProblemTexts t = texts();
  Json garment = twoRectangles();
  garment["symmetries"] =
      Json::parse(R"([{"kind": "piece", "piece": "front", "axis": [[0, 10], [10, 10]]}])");
  t.garment = garment.dump();
  const auto problem = makeProblem(t);
  ASSERT_TRUE(problem.ok()) << problem.error().message;
  ASSERT_EQ(problem.value().imposed.size(), 1u);
  EXPECT_LT((problem.value().imposed[0].map({2, 3}) - Vec2(2, 17)).norm(), 1e-6);
  ASSERT_EQ(problem.value().notes.size(), 1u);
  EXPECT_NE(problem.value().notes[0].find("shirt.json"), std::string::npos);
}

TEST(ProblemFromFiles, ImposesNoSymmetryOnTheMethodThatKnowsNone) {
  ProblemTexts t = texts();
  t.method = Method::kWs19;
  t.seed = 7;
  const auto problem = makeProblem(t);
  ASSERT_TRUE(problem.ok()) << problem.error().message;
  EXPECT_TRUE(problem.value().imposed.empty());
  EXPECT_FALSE(problem.value().known.empty());
  EXPECT_EQ(problem.value().notes.size(), 1u);
  EXPECT_EQ(problem.value().options.method, Method::kWs19);
  EXPECT_EQ(problem.value().options.seed, 7u);
}

TEST(ProblemFromFiles, JoinsTheMarkedLinesOfGarmentAndOptions) {
  const char* match =
      R"([{"a": {"piece": "front", "line": [[1, 0], [1, 5]]}, "b": {"piece": "back", "line": [[9, 0], [9, 5]]}}])";
  Json garment = twoRectangles();
  garment["matches"] = Json::parse(match);
  ProblemTexts t = texts();
  t.garment = garment.dump();
  t.options = std::string("{\"matches\": ") + match + "}";
  const auto problem = makeProblem(t);
  ASSERT_TRUE(problem.ok()) << problem.error().message;
  EXPECT_EQ(problem.value().options.matches.size(), 2u);
}

TEST(ProblemFromFiles, NamesTheFileInWhichSomethingIsWrong) {
  expectError(makeProblem(texts("{")), Failure::kNotJson, {"daisy.json"});
  expectError(makeProblem(texts(kMirrored, "{")), Failure::kNotJson, {"mirror.json"});
  expectError(makeProblem(texts(kMirrored, "auto", "{")), Failure::kNotJson, {"options.json"});
  ProblemTexts t = texts();
  t.garment = "{";
  expectError(makeProblem(t), Failure::kNotJson, {"shirt.json"});
  expectError(
      makeProblem(texts(kMirrored, R"({"symmetries": [{"kind": "piece", "piece": "cap"}]})")),
      Failure::kSymmetryUnknownPiece, {"mirror.json", "'cap'"});
  expectError(
      makeProblem(texts(
          kMirrored,
          R"({"symmetries": [{"kind": "piece", "piece": "front", "axis": [[0, 0], [0, 20]]}]})")),
      Failure::kSymmetryDoesNotMirror, {"mirror.json", "'front'", "cm"});
}

}  // namespace
}  // namespace seamwise
