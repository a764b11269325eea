#include "io/problem_json.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "io/garment_json.h"
#include "io/options_json.h"
#include "io/print_json.h"
#include "io/symmetry_json.h"
#include "solve/placing_rules.h"

namespace seamwise {
namespace {

using Symmetries = std::vector<BodySymmetry>;

bool carries(const WallpaperGroup& group, const BodySymmetry& symmetry) {
  return symmetry.single() ? group.carriesSingle() : group.carriesPair();
}

bool concerns(const BodySymmetry& symmetry, const BodySymmetry& other) {
  for (const int piece : symmetry.pieces)
    if (piece == other.pieces[0] || piece == other.pieces[1]) return true;
  return false;
}

/// `first` and those of `more` that concern none of its pieces.
Symmetries joined(Symmetries first, const Symmetries& more) {
  const std::size_t treated = first.size();
  for (const BodySymmetry& symmetry : more) {
    const auto end = first.begin() + static_cast<std::ptrdiff_t>(treated);
    if (std::none_of(first.begin(), end,
                     [&](const BodySymmetry& given) { return concerns(symmetry, given); }))
      first.push_back(symmetry);
  }
  return first;
}

/// Drops what the group cannot carry and says so, once for single pieces and once for pairs.
Symmetries carried(const Symmetries& wanted, const Garment& garment, const WallpaperGroup& group,
                   std::vector<Note>* notes) {
  Symmetries kept;
  std::string singles, pairs;
  std::vector<int> of_singles, of_pairs;
  for (const BodySymmetry& symmetry : wanted) {
    if (carries(group, symmetry)) {
      kept.push_back(symmetry);
      continue;
    }
    std::string& list = symmetry.single() ? singles : pairs;
    list += (list.empty() ? "" : ", ") + namesOf(garment, symmetry);
    std::vector<int>& pieces = symmetry.single() ? of_singles : of_pairs;
    for (const int piece : piecesOf(symmetry)) pieces.push_back(piece);
  }
  const std::string name(group.data().name);
  if (!singles.empty())
    notes->push_back({"noMirrors",
                      "Print group " + name +
                          " has no mirrors, so these pieces are not kept symmetric: " + singles +
                          "; " + groupsForSingle() + " could.",
                      std::move(of_singles)});
  if (!pairs.empty())
    notes->push_back(
        {"noGlides",
         "Print group " + name +
             " has neither mirrors nor glides, so these pairs are not kept symmetric: " + pairs +
             "; " + groupsForPair() + " could.",
         std::move(of_pairs)});
  return kept;
}

/// Registered on the garment; errors name the file.
Symmetries registered(const Garment& garment, const std::vector<SymmetryRequest>& requests,
                      const std::string& file) {
  Outcome<Symmetries> found = registerSymmetries(garment, requests);
  if (!found.ok()) throw InputError{inFile(found.error(), file)};
  return std::move(found).value();
}

void requireCarried(const Symmetries& wanted, const Garment& garment, const WallpaperGroup& group,
                    const Place& place) {
  for (const BodySymmetry& symmetry : wanted) {
    if (carries(group, symmetry)) continue;
    const std::string what =
        symmetry.single() ? "makes piece " + namesOf(garment, symmetry) + " symmetric in itself"
                          : "makes " + namesOf(garment, symmetry) + " a mirrored pair";
    Place here = place;
    here.piece = symmetry.pieces[0];
    here.fail(Failure::kSymmetryGroup,
              what + ", which print group " + std::string(group.data().name) +
                  " cannot carry; take a print of group " +
                  (symmetry.single() ? groupsForSingle() : groupsForPair()) + ", or leave it out");
  }
}

template <class T>
T valueOf(Outcome<T> outcome) {
  if (!outcome.ok()) throw InputError{outcome.error()};
  return std::move(outcome).value();
}

void readOptionsInto(const ProblemTexts& texts, Problem* problem) {
  SolveOptions& options = problem->options;
  if (!texts.options.empty())
    options = valueOf(readOptions(texts.options, texts.options_name, problem->garment));
  options.method = texts.method;
  options.seed = texts.seed;
  auto& matches = problem->garment.matches;
  options.matches.insert(options.matches.end(), matches.begin(), matches.end());
  matches.clear();
}

void readSymmetriesInto(const ProblemTexts& texts, const std::vector<SymmetryRequest>& of_garment,
                        const Symmetries& detected, Problem* problem) {
  const Garment& garment = problem->garment;
  const WallpaperGroup& group = problem->print.group;
  problem->symmetries_optional = texts.symmetry == "auto";
  Symmetries treated = detected;
  if (texts.symmetry == "auto") {
    if (!of_garment.empty()) {
      treated = registered(garment, of_garment, texts.garment_name);
      problem->notes.push_back(
          {"symmetriesStated", "The symmetries are those that " + texts.garment_name + " states."});
    }
    problem->imposed = carried(treated, garment, group, &problem->notes);
  } else if (texts.symmetry != "none") {
    const Place place{texts.symmetry_name, Failure::kSymmetryMalformed,
                      Failure::kSymmetryMalformed};
    const auto requests = valueOf(readSymmetries(texts.symmetry, texts.symmetry_name));
    treated = registered(garment, requests, texts.symmetry_name);
    requireCarried(treated, garment, group, place);
    problem->imposed = treated;
  }
  problem->known = joined(std::move(treated), detected);
  if (texts.method == Method::kWs19 && !problem->imposed.empty()) {
    problem->imposed.clear();
    problem->notes.push_back(
        {"ws19", "Method ws19 knows no global symmetries, so none is imposed."});
  }
}

}  // namespace

bool ProblemReader::advance() {
  if (error_) return false;
  if (detection_) return detection_->advance();
  const auto read = guarded<bool>(Place{texts_.garment_name}, [&] {
    GarmentFile file = valueOf(readGarment(texts_.garment, texts_.garment_name));
    problem_.reset(new Problem{std::move(file.garment),
                               valueOf(readPrint(texts_.print, texts_.print_name)),
                               {},
                               {},
                               false,
                               {},
                               std::move(file.notes)});
    of_garment_ = std::move(file.symmetries);
    readOptionsInto(texts_, problem_.get());
    detection_ = std::make_unique<SymmetryDetection>(problem_->garment);
    return true;
  });
  if (!read.ok()) error_ = read.error();
  return read.ok();
}

Outcome<Problem> ProblemReader::take() {
  if (error_) return *error_;
  return guarded<Problem>(Place{texts_.garment_name}, [&] {
    readSymmetriesInto(texts_, of_garment_, detection_->found(), problem_.get());
    if (auto note = assumedGrain(*problem_, texts_.garment_name))
      problem_->notes.push_back(std::move(*note));
    return std::move(*problem_);
  });
}

Outcome<Problem> makeProblem(const ProblemTexts& texts) {
  ProblemReader reader(texts);
  while (reader.advance()) {
  }
  return reader.take();
}

}  // namespace seamwise
