// The core writes the table of groups and options for the scripts: SEAMWISE_WRITE=1 rewrites the
// file.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

#include "alignment/bound/lower_bound.h"
#include "problem/option_limits.h"
#include "tuning/proof.h"
#include "wallpaper/group.h"

namespace seamwise {
namespace {

constexpr const char* kFile = SEAMWISE_TABLES;

std::string shown(double value) {
  std::ostringstream out;
  out << value;
  return std::regex_replace(out.str(), std::regex("e([-]?)[+]?0*"), "e$1");  // 1e-9, not 1e-09
}

const char* nameOf(LatticeType lattice) {
  switch (lattice) {
    case LatticeType::kOblique:
      return "oblique";
    case LatticeType::kRectangular:
      return "rectangular";
    case LatticeType::kRhombic:
      return "rhombic";
    case LatticeType::kSquare:
      return "square";
    case LatticeType::kHexagonal:
      return "hexagonal";
  }
  return "";
}

std::string groupRow(const GroupData& group) {
  std::string row = "  " + std::string(group.name) + ": ['" + nameOf(group.lattice) + "', " +
                    std::to_string(group.order);
  std::string generators;
  for (const LatticeElement& g : group.generators) {
    generators += generators.empty() ? "[" : ", [";
    for (const int m : g.m) generators += std::to_string(m) + ", ";
    generators += shown(g.a[0]) + ", " + shown(g.a[1]) + "]";
  }
  return row + ", [" + generators + "]],\n";
}

std::string limitRow(const char* name, const Range& range) {
  return "  " + std::string(name) + ": [" + shown(range.least) + ", " + shown(range.most) + "],\n";
}

std::string tables() {
  std::string text =
      "/** Written by the core, `npm run tables`: the 17 wallpaper groups, and what options may "
      "be. "
      "*/\n\n"
      "export const groupNames = [\n";
  for (const GroupData& group : wallpaperGroups()) text += "  '" + std::string(group.name) + "',\n";
  text +=
      "] as const;\n\n"
      "/** Lattice type, order of the point group, generators (u, v) -> M (u, v) + a in lattice "
      "coordinates: M by rows, a. */\n"
      "export const groupTable = {\n";
  for (const GroupData& group : wallpaperGroups()) text += groupRow(group);
  text +=
      "} as const;\n\n"
      "/** The least and the most that an option may be. */\n"
      "export const optionLimits = {\n";
  text += limitRow("maxChangeCm", kMaxChangeCm);
  text += limitRow("edgeLengthCm", kEdgeLengthCm);
  text += limitRow("alpha", kAlpha);
  text += limitRow("effort", kEffort);
  text += limitRow("starts", kStarts);
  text += limitRow("proof", kProof);
  text += limitRow("toleranceDeg", kToleranceDeg);
  text += limitRow("weight", kSeamWeight);
  text += limitRow("repeatCm", {kShortestRepeat, kLongestRepeat});
  text +=
      "} as const;\n\n"
      "/** A placing that costs no more than this share above what is proven is the best. */\n"
      "export const provenShare = ";
  return text + shown(ProofTuning::kProven) + ";\n";
}

TEST(CoreTables, AreWhatTheScriptsHave) {
  if (std::getenv("SEAMWISE_WRITE")) std::ofstream(kFile) << tables();
  std::ifstream in(kFile);
  std::stringstream text;
  text << in.rdbuf();
  EXPECT_EQ(text.str(), tables()) << "npm run tables writes " << kFile;
}

}  // namespace
}  // namespace seamwise
