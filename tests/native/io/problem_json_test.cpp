#include "io/problem_json.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/garment_texts.h"

namespace seamwise {
namespace {

using testing::expectError;
using testing::twoRectangles;
using testing::twoTriangles;

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

TEST(ProblemFromFiles, ImposesTheSymmetriesItFindsWhenThePrintCarriesThem) {
  const auto problem = makeProblem(texts());
  ASSERT_TRUE(problem.ok()) << problem.error().message;
  EXPECT_FALSE(problem.value().symmetries.imposed.empty());
  EXPECT_EQ(problem.value().symmetries.imposed.size(), problem.value().symmetries.known.size());
  EXPECT_TRUE(problem.value().notes.empty());
}

TEST(ProblemFromFiles, AreReadInStepsThatTellHowFarTheyAre) {
  ProblemReader reader(texts());
  EXPECT_EQ(reader.fraction(), 0);
  int steps = 0;
  double before = 0;
  for (; reader.advance(); ++steps) {
    EXPECT_GE(reader.fraction(), before);
    before = reader.fraction();
  }
  EXPECT_GT(steps, 3);  // the files, then the possible symmetries
  EXPECT_EQ(reader.fraction(), 1);
  EXPECT_FALSE(reader.advance());
  EXPECT_EQ(reader.take().value().symmetries.imposed,
            makeProblem(texts()).value().symmetries.imposed);
}

TEST(ProblemFromFiles, DropsWhatThePrintCannotCarryAndSaysSo) {
  ProblemTexts t = texts(kPlainRepeat);
  t.garment = twoTriangles().dump();
  const auto problem = makeProblem(t);
  ASSERT_TRUE(problem.ok()) << problem.error().message;
  EXPECT_TRUE(problem.value().symmetries.imposed.empty());
  EXPECT_EQ(problem.value().symmetries.known.size(), 1u);
  ASSERT_EQ(problem.value().notes.size(), 1u);
  for (const char* word : {"p1", "'left' and 'right'", "pg"})
    EXPECT_NE(problem.value().notes[0].text.find(word), std::string::npos)
        << problem.value().notes[0].text;
}

TEST(ProblemFromFiles, CarriesPairsButNoSinglePiecesInAPrintOfGlides) {
  ProblemTexts t = texts(kGlides);
  t.garment = twoTriangles().dump();
  const auto pair = makeProblem(t);
  ASSERT_TRUE(pair.ok()) << pair.error().message;
  EXPECT_EQ(pair.value().symmetries.imposed.size(), 1u);

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
  EXPECT_TRUE(problem.value().symmetries.imposed.empty());
  EXPECT_FALSE(problem.value().symmetries.known.empty());
}

TEST(ProblemFromFiles, ImposesWhatIsAskedForAndKnowsTheRest) {
  const auto problem =
      makeProblem(texts(kMirrored, R"({"symmetries": [{"kind": "piece", "piece": "back"}]})"));
  ASSERT_TRUE(problem.ok()) << problem.error().message;
  ASSERT_EQ(problem.value().symmetries.imposed.size(), 1u);
  EXPECT_EQ(problem.value().symmetries.imposed[0].pieces[0], 1);
  EXPECT_TRUE(problem.value().symmetries.imposed[0].single());
  for (const BodySymmetry& known : problem.value().symmetries.known)
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
  ASSERT_EQ(problem.value().symmetries.imposed.size(), 1u);
  EXPECT_LT((problem.value().symmetries.imposed[0].map({2, 3}) - Vec2(2, 17)).norm(), 1e-6);
  ASSERT_EQ(problem.value().notes.size(), 1u);
  EXPECT_NE(problem.value().notes[0].text.find("shirt.json"), std::string::npos);
}

TEST(ProblemFromFiles, ImposesNoSymmetryOnTheMethodThatKnowsNone) {
  ProblemTexts t = texts();
  t.method = Method::kWs19;
  t.seed = 7;
  const auto problem = makeProblem(t);
  ASSERT_TRUE(problem.ok()) << problem.error().message;
  EXPECT_TRUE(problem.value().symmetries.imposed.empty());
  EXPECT_FALSE(problem.value().symmetries.known.empty());
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
