#pragma once
#include <vector>

#include "alignment/model/sampled_seams.h"

namespace seamwise {

/// ICP on the print: improves the alignments of the `active` leaders together; the others are
/// fixed. Gauss-Newton on all turns and shifts, with the nearest element of each sample frozen.
/// Weights 1/d minimise the sum of distances, not of squares. Elements are chosen again after each
/// step. The cost never increases.
/// @param slack   see SampledSeams::cost
/// @param work   grows by the number of multiplications for solving; may be null
/// @return   the cost of the seams that touch an active leader, cm2
template <class Real>
double refine(const MatchProblem& problem, const SampledSeams<Real>& seams, Alignments& at,
              std::vector<int> active, int iterations, double slack = 0, double* work = nullptr);

extern template double refine(const MatchProblem&, const SampledSeams<float>&, Alignments&,
                              std::vector<int>, int, double, double*);
extern template double refine(const MatchProblem&, const SampledSeams<double>&, Alignments&,
                              std::vector<int>, int, double, double*);

}  // namespace seamwise
