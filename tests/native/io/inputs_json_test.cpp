#include <gtest/gtest.h>

#include <cmath>

#include "io/print_json.h"
#include "io/symmetry_json.h"
#include "support/garment_texts.h"

namespace seamwise {
namespace {

using testing::expectError;
using testing::mustRead;
using testing::panelOf;
using testing::twoRectangles;
using testing::twoTriangles;

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

TEST(PrintFile, MayShowTwoCellsInOnePicture) {
  const auto print = readPrint(
      R"({"group": "p1", "w1": [6, -2], "w2": [6, 2], "image": "leaf.png", "cell": "centred"})",
      "leaf.json");
  ASSERT_TRUE(print.ok()) << print.error().message;
  EXPECT_EQ(print.value().group.w1(), Vec2(6, -2));
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

}  // namespace
}  // namespace seamwise
