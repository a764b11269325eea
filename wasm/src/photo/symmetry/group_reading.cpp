#include "photo/symmetry/group_reading.h"

#include <algorithm>

#include "photo/symmetry/stripes.h"
#include "photo/symmetry/symmetry_tests.h"
#include "tuning/group_reading.h"

namespace seamwise {
namespace {

using SymmetryTuning = GroupReadingTuning;

SymmetryVerdict verdictOn(const SymmetryResidual& residual) {
  if (residual.rho <= SymmetryTuning::kHasShare && residual.worst <= SymmetryTuning::kHasWorst) {
    return SymmetryVerdict::kHas;
  }
  const bool breaks = residual.rho >= SymmetryTuning::kHasNotShare ||
                      residual.worst >= SymmetryTuning::kHasNotWorst;
  return breaks ? SymmetryVerdict::kHasNot : SymmetryVerdict::kAlmost;
}

GroupVerdict testedGroup(const GroupData& group, const std::vector<GroupEmbedding>& embeddings,
                         SymmetryTests& tests) {
  GroupVerdict verdict;
  verdict.group = &group;
  const GroupEmbedding* best = nullptr;
  double least = 0;
  for (const GroupEmbedding& embedding : embeddings) {
    const Vec2 origin = tests.bestOrigin(embedding);
    const double missed = tests.missedBy(embedding, origin);
    if (best != nullptr && missed >= least - 1e-6) continue;
    best = &embedding;
    least = missed;
    verdict.origin = origin;
    verdict.basis = embedding.basis;
  }
  if (best == nullptr) return verdict;
  const SymmetryResidual residual = tests.residual(*best, verdict.origin);
  verdict.rho = residual.rho;
  verdict.worst = residual.worst;
  verdict.raw = residual.raw;
  verdict.verdict = verdictOn(residual);
  return verdict;
}

int indexOf(const std::array<GroupVerdict, 17>& groups, std::string_view name) {
  for (std::size_t k = 0; k < groups.size(); ++k) {
    if (groups[k].group->name == name) return static_cast<int>(k);
  }
  return 0;
}

/// Sets the groups of a stripe. It has any length along itself, so a right angle always exists: pm
/// holds, and pmm if a half turn does.
void readStripes(GroupReading& reading, const std::array<int, 2>& along, const Mat2& gram) {
  reading.stripes = true;
  const GroupVerdict half_turn = reading.groups[indexOf(reading.groups, "p2")];
  for (const std::string_view name : {"pm", "pmm"}) {
    GroupVerdict& verdict = reading.groups[indexOf(reading.groups, name)];
    verdict.basis = stripeBasis(along, gram);
    verdict.origin = half_turn.origin;
    const bool is_even = name == "pmm";
    verdict.rho = is_even ? half_turn.rho : 0;
    verdict.worst = is_even ? half_turn.worst : 0;
    verdict.raw = is_even ? half_turn.raw : 0;
    verdict.verdict = is_even ? half_turn.verdict : SymmetryVerdict::kHas;
  }
  const bool is_even = half_turn.verdict == SymmetryVerdict::kHas;
  reading.best = indexOf(reading.groups, is_even ? "pmm" : "pm");
}

/// Returns the largest group present; of groups of equal order, the one that fits best.
int largestOf(const std::array<GroupVerdict, 17>& groups) {
  int best = 0;
  for (std::size_t k = 1; k < groups.size(); ++k) {
    if (groups[k].verdict != SymmetryVerdict::kHas) continue;
    const int more = groups[k].group->order - groups[best].group->order;
    if (more > 0 || (more == 0 && groups[k].rho < groups[best].rho)) best = static_cast<int>(k);
  }
  return best;
}

Confidence confidenceIn(const GroupReading& reading) {
  const GroupVerdict& best = reading.groups[reading.best];
  bool is_almost_more = false;
  for (const GroupVerdict& other : reading.groups) {
    is_almost_more |=
        other.verdict == SymmetryVerdict::kAlmost && other.group->order > best.group->order;
  }
  const bool is_clear =
      best.rho <= SymmetryTuning::kHasShare / 2 && best.worst <= 2 * SymmetryTuning::kHasWorst / 3;
  if (is_clear && !is_almost_more) return Confidence::kSure;
  return is_clear || !is_almost_more ? Confidence::kLikely : Confidence::kUncertain;
}

}  // namespace

GroupReader::GroupReader(const CellPicture& cell, const Mat2& gram, double tolerance)
    : spectrum_(cell, gram), tests_(spectrum_), gram_(gram), tolerance_(tolerance) {}

bool GroupReader::advance() {
  if (tested_ == reading_.groups.size()) return false;
  const GroupData& group = wallpaperGroups()[tested_];
  reading_.groups[tested_++] = testedGroup(group, embeddingsOf(group, gram_, tolerance_), tests_);
  if (tested_ < reading_.groups.size()) return true;
  choose();
  return false;
}

double GroupReader::fraction() const {
  return static_cast<double>(tested_) / static_cast<double>(reading_.groups.size());
}

void GroupReader::choose() {
  const auto along = stripeOf(spectrum_);
  if (isStripe(along)) {
    readStripes(reading_, along, gram_);
  } else {
    reading_.best = largestOf(reading_.groups);
  }
  const auto has_half_turn = [](const LatticeElement& e) {
    return e.m == IntegerMatrix{-1, 0, 0, -1};
  };
  const auto elements = cosets(*reading_.groups[reading_.best].group);
  reading_.one_way = std::none_of(elements.begin(), elements.end(), has_half_turn);
  const bool is_plain = spectrum_.energy() < SymmetryTuning::kPlainEnergy * spectrum_.noiseEnergy();
  reading_.confidence = is_plain ? Confidence::kUncertain : confidenceIn(reading_);
}

}  // namespace seamwise
