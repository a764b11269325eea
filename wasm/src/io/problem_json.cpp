#include "io/problem_json.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "io/garment_json.h"
#include "io/options_json.h"
#include "io/print_json.h"
#include "io/symmetry_json.h"
#include "problem/placing_rules.h"
#include "problem/pleats.h"

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

/// `first` plus those of `more` that concern none of its pieces.
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

/// Drops the symmetries that the group cannot carry, with one note for single pieces and one for
/// pairs.
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

/// Registers requests on the garment; errors name the file.
Outcome<Symmetries> registered(const Garment& garment, const std::vector<SymmetryRequest>& requests,
                               const std::string& file) {
  Outcome<Symmetries> found = registerSymmetries(garment, requests);
  if (!found.ok()) return inFile(found.error(), file);
  return found;
}

/// The error of the first symmetry that the group cannot carry.
std::optional<Error> notCarried(const Symmetries& wanted, const Garment& garment,
                                const WallpaperGroup& group, const std::string& file) {
  for (const BodySymmetry& symmetry : wanted) {
    if (carries(group, symmetry)) continue;
    const std::string what =
        symmetry.single() ? "makes piece " + namesOf(garment, symmetry) + " symmetric in itself"
                          : "makes " + namesOf(garment, symmetry) + " a mirrored pair";
    Place here{file};
    here.piece = symmetry.pieces[0];
    return here.error(Failure::kSymmetryGroup,
                      what + ", which print group " + std::string(group.data().name) +
                          " cannot carry; take a print of group " +
                          (symmetry.single() ? groupsForSingle() : groupsForPair()) +
                          ", or leave it out");
  }
  return std::nullopt;
}

std::optional<Error> readOptionsInto(const ProblemTexts& texts, Problem* problem) {
  SolveOptions& options = problem->options;
  if (!texts.options.empty()) {
    auto read = readOptions(texts.options, texts.options_name, problem->garment);
    if (!read.ok()) return read.error();
    options = std::move(read).value();
  }
  options.method = texts.method;
  options.seed = texts.seed;
  auto& matches = problem->garment.matches;
  options.matches.insert(options.matches.end(), matches.begin(), matches.end());
  matches.clear();
  return std::nullopt;
}

std::optional<Error> readSymmetriesInto(const ProblemTexts& texts,
                                        const std::vector<SymmetryRequest>& of_garment,
                                        const Symmetries& detected, Problem* problem) {
  const Garment& garment = problem->garment;
  const WallpaperGroup& group = problem->print.group;
  GarmentSymmetries& symmetries = problem->symmetries;
  symmetries.optional = texts.symmetry == "auto";
  Symmetries treated = detected;
  if (texts.symmetry == "auto") {
    if (!of_garment.empty()) {
      auto stated = registered(garment, of_garment, texts.garment_name);
      if (!stated.ok()) return stated.error();
      treated = std::move(stated).value();
      problem->notes.push_back(
          {"symmetriesStated", "The symmetries are those that " + texts.garment_name + " states."});
    }
    symmetries.imposed = carried(treated, garment, group, &problem->notes);
  } else if (texts.symmetry != "none") {
    const auto requests = readSymmetries(texts.symmetry, texts.symmetry_name);
    if (!requests.ok()) return requests.error();
    auto wanted = registered(garment, requests.value(), texts.symmetry_name);
    if (!wanted.ok()) return wanted.error();
    treated = std::move(wanted).value();
    if (auto error = notCarried(treated, garment, group, texts.symmetry_name)) return error;
    symmetries.imposed = treated;
  }
  symmetries.known = joined(std::move(treated), detected);
  if (texts.method == Method::kWs19 && !symmetries.imposed.empty()) {
    symmetries.imposed.clear();
    problem->notes.push_back(
        {"ws19", "Method ws19 knows no global symmetries, so none is imposed."});
  }
  return std::nullopt;
}

}  // namespace

bool ProblemReader::advance() {
  if (error_) return false;
  if (detection_) return detection_->advance();
  error_ = read();
  if (!error_) detection_ = std::make_unique<SymmetryDetection>(problem_->garment);
  return !error_;
}

std::optional<Error> ProblemReader::read() {
  Outcome<GarmentFile> garment = readGarment(texts_.garment, texts_.garment_name);
  if (!garment.ok()) return garment.error();
  Outcome<Print> print = readPrint(texts_.print, texts_.print_name);
  if (!print.ok()) return print.error();
  GarmentFile& file = garment.value();
  problem_.reset(new Problem{
      std::move(file.garment), std::move(print).value(), {}, {}, std::move(file.notes), {}});
  of_garment_ = std::move(file.symmetries);
  if (auto error = readOptionsInto(texts_, problem_.get())) return error;
  fitPleats(problem_.get());
  return std::nullopt;
}

Outcome<Problem> ProblemReader::take() {
  if (!error_)
    error_ = readSymmetriesInto(texts_, of_garment_, detection_->found(), problem_.get());
  if (error_) return *error_;
  if (auto note = assumedGrain(*problem_, texts_.garment_name))
    problem_->notes.push_back(std::move(*note));
  problem_->groups = seamGroups(problem_->garment, problem_->symmetries.known);
  if (problem_->options.method != Method::kBest)
    problem_->options.visibility = Visibility::kEven;  // as published
  if (problem_->options.visibility == Visibility::kByPlace)
    weighByVisibility(problem_->groups, &problem_->garment, &problem_->options.matches);
  return std::move(*problem_);
}

Outcome<Problem> makeProblem(const ProblemTexts& texts) {
  ProblemReader reader(texts);
  while (reader.advance()) {
  }
  return reader.take();
}

}  // namespace seamwise
