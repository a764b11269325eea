#include "solve/solver.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/decimal.h"
#include "deform/shape_limits.h"
#include "methods/drafted.h"
#include "methods/effort_run.h"
#include "methods/paper_run.h"
#include "methods/proof_run.h"
#include "problem/placing_rules.h"
#include "problem/prepare_symmetric.h"
#include "solve/other_alignments.h"
#include "solve/remarks.h"
#include "solve/seam_figures.h"
#include "solve/seam_states.h"
#include "tuning/progress.h"

namespace seamwise {
namespace {

void applySeamOptions(const SolveOptions& options, Pattern& pattern) {
  for (const auto& [seam, weight] : options.weights) pattern.seams[seam].weight = weight;
  for (int seam : options.unmatched) pattern.seams[seam].matched = false;
  for (Seam& seam : pattern.seams)
    for (int piece : options.plain)
      if (seam.a.piece == piece || seam.b.piece == piece) seam.matched = false;
}

Error unsewable(int seam) {
  return {Failure::kMesh,
          "The two sides of seam " + decimal(seam) +
              " bend too differently to be sewn edge to edge; smooth the sharper one, split it at "
              "its bend, or raise maxChangeCm.",
          -1, seam};
}

}  // namespace

struct Solver::State {
  explicit State(Problem p) : problem(std::move(p)) {
    // Method ws19 uses no symmetry of the body.
    if (problem.options.method == Method::kWs19) problem.symmetries.imposed.clear();
  }
  Problem problem;
  Pattern pattern;
  std::optional<Pattern> symmetric;  ///< pattern with more symmetries than requested
  std::shared_ptr<MeshPlans> plans;
  std::vector<Note> notes;  ///< items dropped or assumed
  MatchRules rules;
  std::optional<MatchProblem> match;  ///< the pieces as drafted
  Alignments drafted;
  SolveMemo own;  ///< used if the caller has none
  SolveMemo* memo = &own;
  std::vector<Mirror> known;  ///< mirrors at the start of a search
  std::unique_ptr<Run> run;
  std::unique_ptr<ProofRun> proof;
  double reported = ProgressTuning::kPrepared;

  std::unique_ptr<Run> best() {
    std::optional<EffortRun::Mesh> more;
    if (symmetric) more.emplace(EffortRun::Mesh{*symmetric, plans->plans});
    return std::make_unique<EffortRun>(
        problem, EffortRun::Mesh{pattern, symmetric ? plans->freed : plans->plans}, more, known,
        rules, memo->searches, memo->runs);
  }
};

Solver::Solver(std::unique_ptr<State> state) : state_(std::move(state)) {}
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;
Solver::~Solver() = default;

Outcome<Solver> Solver::make(Problem problem, SolveMemo* memo) {
  SolverSetup setup(std::move(problem), memo);
  while (setup.advance()) {
  }
  return setup.take();
}

SolverSetup::SolverSetup(Problem problem, SolveMemo* memo)
    : state_(std::make_unique<Solver::State>(std::move(problem))),
      memo_(memo),
      preparation_(state_->problem, memo ? &memo->mesh : nullptr) {}

SolverSetup::~SolverSetup() = default;

bool SolverSetup::advance() { return preparation_.advance(); }
double SolverSetup::fraction() const { return preparation_.fraction(); }

Outcome<Solver> SolverSetup::take() {
  Outcome<PreparedProblem> outcome = preparation_.take();
  if (!outcome.ok()) return outcome.error();
  PreparedProblem& prepared = outcome.value();
  Solver::State& state = *state_;
  const Problem& p = state.problem;
  state.pattern = std::move(prepared.asked.pattern);
  state.symmetric = std::move(prepared.symmetric);
  state.plans = std::move(prepared.asked.plans);
  state.known = std::move(prepared.known);
  state.notes = p.notes;
  for (Note& note : prepared.asked.notes) state.notes.push_back(std::move(note));
  if (memo_) state.memo = memo_;
  applySeamOptions(p.options, state.pattern);
  if (state.symmetric) applySeamOptions(p.options, *state.symmetric);
  state.rules = {pieceRules(p), p.options.matches, p.options.continuous_only};
  state.match.emplace(makeMatchProblem(state.pattern, restShapes(state.pattern),
                                       state.pattern.mirrors, state.rules, p.print.group));
  state.drafted = draftedLayout(p, *state.match);
  for (Note& remark : remarksOn(state.pattern)) state.notes.push_back(std::move(remark));
  if (p.options.method == Method::kBest)
    state.run = state.best();
  else
    state.run =
        std::make_unique<PaperRun>(p, state.pattern, state.rules, state.drafted, &state.notes);
  return Solver(std::move(state_));
}

bool Solver::advance(int steps) {
  for (int k = 0; k < steps; ++k)
    if (!state_->run->advance()) return false;
  return true;
}

Phase Solver::phase() const { return state_->run->phase(); }

double Solver::fraction() const {
  state_->reported = std::max(state_->reported, state_->run->fraction());
  return state_->reported;
}

int Solver::attempt() const { return state_->run->attempt(); }
const Alignments& Solver::partial() const { return state_->run->alignment(); }
AlignmentSearch* Solver::searching() { return state_->run->searching(); }
const std::vector<Note>& Solver::notes() const { return state_->notes; }
const Pattern& Solver::pattern() const { return state_->pattern; }

PrintedPattern Solver::unsolved() const {
  const WallpaperGroup& group = state_->problem.print.group;
  PrintedPattern printed;
  printed.pattern = state_->pattern;
  if (const auto& fits = state_->problem.pleat_fits)
    for (const PleatFit& fit : *fits)
      for (Vec2& p : printed.pattern.pieces[fit.piece].rest) p = fit.drafted(p);
  printed.shapes = restShapes(printed.pattern);
  printed.garment = state_->problem.garment;
  printed.garment.matches = state_->problem.options.matches;
  printed.alignment = state_->drafted;
  printed.joins.resize(printed.pattern.seams.size());
  printed.mismatch.resize(printed.pattern.seams.size());
  printed.group = group.data().name;
  printed.w1 = group.w1(), printed.w2 = group.w2();
  const auto measured = [&](const WallpaperGroup& by) {
    MismatchTotals totals;
    totals.total_random = randomMismatch(by, printed.pattern, printed.shapes);
    totals.total_drafted = totalMismatch(by, printed.pattern, printed.shapes, printed.alignment);
    return totals;
  };
  static_cast<MismatchTotals&>(printed) = measured(group);
  if (state_->match->continuous_only) printed.continuous = measured(state_->match->joining());
  printed.notes = state_->notes;
  return printed;
}

Outcome<Result> Solver::finish() {
  Run& run = *state_->run;
  while (run.advance()) {
  }
  const Problem& problem = state_->problem;
  const WallpaperGroup& group = problem.print.group;
  Result result;
  static_cast<PrintedPattern&>(result) = unsolved();
  const Shapes rest = std::exchange(result.shapes, run.shapes());
  for (std::size_t s = 0; s < result.pattern.seams.size(); ++s)
    if (seamError(result.pattern.seams[s], result.shapes) > kSeamTolerance)
      return unsewable(static_cast<int>(s));
  result.alignment = run.alignment();
  result.search = run.search();
  result.search_bound = run.searchBound();
  result.search_cost = run.searchCost();
  for (std::size_t s = 0; s < result.pattern.seams.size(); ++s) {
    const Seam& seam = result.pattern.seams[s];
    result.joins[s] =
        bestJoin(group, seam, result.shapes, result.alignment, problem.options.continuous_only);
    result.mismatch[s] = joinMismatch(result.joins[s], seam, result.shapes, result.alignment);
  }
  const auto measure = [&](const WallpaperGroup& by, MismatchTotals* totals) {
    totals->total_search = totalMismatch(by, result.pattern, rest, result.search);
    totals->total_aligned = totalMismatch(by, result.pattern, rest, result.alignment);
    totals->total = measureTotal(by, result.pattern, result.shapes, result.alignment);
  };
  measure(group, &result);
  const WallpaperGroup joining = state_->match->joining();
  if (result.continuous) measure(joining, &*result.continuous);
  result.drafted = state_->drafted;
  if (problem.options.other_alignments)
    result.others =
        otherAlignments(joining, result.pattern, rest, {result.alignment, result.search},
                        run.compared(), BestRun::reachOf(problem.options));
  fillSeamFigures(joining, *state_->match, problem.options.locked, result);
  result.cost = answerCost(joining, result.pattern, result.shapes, result.alignment);
  result.groups = problem.groups;
  result.states = seamStates(joining, *state_->match, problem.options.locked, result.groups,
                             BestRun::reachOf(problem.options), result);
  result.max_moved_cm = greatestMovement(result.pattern, result.shapes);
  if (problem.options.max_change_cm >= kLeastChange)
    if (auto note = remarkOnRest(result.pattern, result.shapes, result.local.worst))
      result.notes.push_back(*std::move(note));
  result.iterations = run.iterations();
  result.factorisations = run.factorisations();
  result.method = problem.options.method;
  result.seed = problem.options.seed;
  return result;
}

bool Solver::prove(int steps) {
  State& state = *state_;
  if (state.problem.options.method != Method::kBest) return false;
  if (!state.proof)
    state.proof = std::make_unique<ProofRun>(state.problem, state.pattern, *state.match,
                                             state.known, state.rules, state.memo->searches);
  for (int k = 0; k < steps; ++k)
    if (!state.proof->advance()) return false;
  return true;
}

Proven Solver::proven() const {
  if (!state_->proof) return {};
  return {state_->proof->bound(), state_->proof->searchCost()};
}

Outcome<Result> solve(Problem problem) {
  Outcome<Solver> solver = Solver::make(std::move(problem));
  if (!solver.ok()) return solver.error();
  return solver.value().finish();
}

}  // namespace seamwise
