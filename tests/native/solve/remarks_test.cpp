#include "solve/remarks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "support/solver_samples.h"

namespace seamwise::testing {
namespace {

std::vector<Note> remarksAfter(const Task& t) {
  Outcome<Solver> solver = Solver::make(problemOf(t));
  EXPECT_TRUE(solver.ok()) << solver.error().message;
  return remarksOn(solver.value().pattern());
}

TEST(Remarks, NamesGatheredSeamsUntilTheyAreLeftOut) {
  Task t = task("gathered-skirt", "pmm");
  const auto remarks = remarksAfter(t);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].text.find("'front' to 'waistband_front'"), std::string::npos)
      << remarks[0].text;
  EXPECT_STREQ(remarks[0].code, "gathered");
  EXPECT_EQ(remarks[0].seams, (std::vector<int>{4, 5}));
  t.options["unmatched"] = {4, 5};
  EXPECT_TRUE(remarksAfter(t).empty());
}

TEST(Remarks, SaysNothingOfASleevesEase) { EXPECT_TRUE(remarksAfter(task("tee", "pmm")).empty()); }

TEST(Remarks, SaysWhenNoSeamIsLeftToMatch) {
  Task t = task("tee", "pmm");
  for (const auto& [name, panel] : panelsOf(t.garment).items()) t.options["plain"].push_back(name);
  const auto remarks = remarksAfter(t);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].text.find("plain"), std::string::npos) << remarks[0].text;
  EXPECT_STREQ(remarks[0].code, "noMatchedSeams");
  t.garment["pattern"]["stitches"] = Json::array();
  t.options = Json::object();
  ASSERT_EQ(remarksAfter(t).size(), 1u);
  EXPECT_NE(remarksAfter(t)[0].text.find("no seams"), std::string::npos);
  EXPECT_STREQ(remarksAfter(t)[0].code, "noSeams");
}

/// Two rectangles, sewn together along a side; the second one's is `ratio` times as long.
Task twoSides(double ratio) {
  const auto panel = [](double length) -> Json {
    Json edges;
    for (int k = 0; k < 4; ++k) edges.push_back({{"endpoints", {k, (k + 1) % 4}}});
    return {{"vertices", {{0, 0}, {10, 0}, {10, length}, {0, length}}}, {"edges", edges}};
  };
  Task t;
  t.garment = {{"pattern",
                {{"panels", {{"one", panel(30)}, {"other", panel(30 * ratio)}}},
                 {"stitches", Json::array({Json::array({{{"panel", "one"}, {"edge", 1}},
                                                        {{"panel", "other"}, {"edge", 3}}})})}}},
               {"properties", {{"units_in_meter", 100}}}};
  t.print = samplePrint("p1");
  t.symmetry = "none";
  return t;
}

TEST(Remarks, SayWhenAllOutlinesStayAsDraftedThoughSeamsAreOff) {
  const auto said = [](const Task& t) {
    const Result r = solved(t);
    return std::any_of(r.notes.begin(), r.notes.end(), [](const Note& note) {
      return std::string_view(note.code) == "leftAsDrafted";
    });
  };
  Task t = twoSides(3);  // gathers cannot match
  EXPECT_TRUE(said(t));
  t.options["maxChangeCm"] = 0;  // shapes stay as drafted by request
  EXPECT_FALSE(said(t));
  EXPECT_FALSE(said(twoSides(1)));                    // sides match as drafted
  EXPECT_FALSE(said(task("princess-dress", "pmm")));  // shaped to match
}

TEST(Remarks, AreNotesOfTheResult) {
  const Result r = solved(task("gathered-skirt", "p1"));
  EXPECT_TRUE(std::any_of(r.notes.begin(), r.notes.end(), [](const Note& note) {
    return note.text.find("unmatched") != std::string::npos;
  }));
}

}  // namespace
}  // namespace seamwise::testing
