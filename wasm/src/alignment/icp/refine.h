#pragma once
#include <vector>

#include "alignment/model/sampled_seams.h"

namespace seamwise {

/// ICP on the print: improves the alignments of the `active` leaders together, the others held.
/// Gauss-Newton on all
/// turns and shifts with the nearest element of each sample frozen, weights 1/d so that the sum of
/// distances (not of squares) falls, elements chosen anew after each step. Never makes the cost
/// worse.
/// @param slack   as in SampledSeams::cost
/// @param work   grows by the multiplications that solving for the steps took; may be null
/// @return   the cost of the seams that touch an active leader, cm2
template <class Real>
double refine(const MatchProblem& problem, const SampledSeams<Real>& seams, Alignments& at,
              std::vector<int> active, int iterations, double slack = 0, double* work = nullptr);

extern template double refine(const MatchProblem&, const SampledSeams<float>&, Alignments&,
                              std::vector<int>, int, double, double*);
extern template double refine(const MatchProblem&, const SampledSeams<double>&, Alignments&,
                              std::vector<int>, int, double, double*);

}  // namespace seamwise
