#include "photo/lattice/lattice_vote.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/sort_by.h"
#include "wallpaper/lattice.h"

namespace seamwise {
namespace {

constexpr int kMostPeaks = 24;
constexpr std::size_t kHighest = 400;  // peaks that are compared with each other
constexpr double kLeastAngle = 0.25;   // |a x b| / |a| |b|; flatter pairs are badly determined
constexpr double kGoodShare = 0.82;  // share of the best score for equally good lattices; measured
constexpr double kSameLattice = 0.03;   // share of a vector's length
constexpr double kLeastOverlap = 0.06;  // minimum overlap of a shift for a meaningful r; chosen
constexpr double kRidge = 0.85;  // share of the highest r that stripes have along them; measured

/// Returns the highest r around a shift, within 3 % of its length.
CorrelationPeak highestNear(const Autocorrelation& correlation, const Vec2& s) {
  const int reach = std::clamp(static_cast<int>(std::lround(0.03 * s.norm())), 1, 4);
  const Vec2 up = s.y() < 0 ? Vec2(-s) : s;
  const int x0 = static_cast<int>(std::lround(up.x())), y0 = static_cast<int>(std::lround(up.y()));
  CorrelationPeak best{s, -1};
  for (int y = std::max(0, y0 - reach); y <= std::min(correlation.reach_y, y0 + reach); ++y) {
    for (int x = std::max(-correlation.reach_x, x0 - reach);
         x <= std::min(correlation.reach_x, x0 + reach); ++x) {
      const double r = correlation.r[y * correlation.columns() + x + correlation.reach_x];
      if (r > best.r) best = {Vec2(x, y) * (s.y() < 0 ? -1 : 1), r};
    }
  }
  return best;
}

/// Returns the offset of the maximum of the parabola through three values from the middle one.
double vertex(double before, double here, double after) {
  const double bend = before - 2 * here + after;
  return bend < 0 ? std::clamp((before - after) / (2 * bend), -0.5, 0.5) : 0;
}

VotedLattice scored(const Autocorrelation& correlation, const Vec2& a, const Vec2& b) {
  constexpr std::array<std::array<int, 2>, 10> kPoints{
      {{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 0}, {0, 2}, {2, 1}, {1, 2}, {2, -1}, {1, -2}}};
  double sum = 0, weight = 0;
  // Least squares fit the basis to the maxima that were found.
  Mat2 points = Mat2::Zero(), products = Mat2::Zero();
  for (const auto& [m, n] : kPoints) {
    const Vec2 s = m * a + n * b;
    if (!correlation.holds(s)) continue;
    const double overlap = correlation.overlapAt(s);
    if (overlap < kLeastOverlap) continue;
    const CorrelationPeak peak = highestNear(correlation, s);
    const double w = std::sqrt(overlap);
    sum += w * peak.r, weight += w;
    const double trust = w * std::max(0.0, peak.r);
    const Vec2 index(m, n);
    points += trust * index * index.transpose();
    products += trust * peak.at * index.transpose();
  }
  VotedLattice lattice{{a, b}, weight > 0 ? sum / weight : 0};
  if (std::abs(points.determinant()) > 1e-9) {
    const Mat2 basis = products * points.inverse();
    lattice.basis = {basis.col(0), basis.col(1)};
  }
  return lattice;
}

double areaOf(const VotedLattice& lattice) {
  return std::abs(cross(lattice.basis[0], lattice.basis[1]));
}

/// Returns whether both bases span the same lattice.
bool isSame(const VotedLattice& x, const VotedLattice& y) {
  if (std::abs(areaOf(x) / areaOf(y) - 1) > 3 * kSameLattice) return false;
  Mat2 basis;
  basis.col(0) = y.basis[0];
  basis.col(1) = y.basis[1];
  const Mat2 inverse = basis.inverse();
  return std::all_of(x.basis.begin(), x.basis.end(), [&](const Vec2& w) {
    const Vec2 index = (inverse * w).array().rint();
    return (basis * index - w).norm() < 2 * kSameLattice * w.norm();
  });
}

}  // namespace

std::vector<CorrelationPeak> dominantPeaks(const Autocorrelation& correlation, double shortest,
                                           int most) {
  const int columns = correlation.columns();
  std::vector<CorrelationPeak> peaks;
  for (int y = 0; y < correlation.reach_y; ++y) {
    for (int x = -correlation.reach_x + 1; x < correlation.reach_x; ++x) {
      if ((y == 0 && x <= 0) || x * x + y * y < shortest * shortest) continue;
      const int i = y * columns + x + correlation.reach_x;
      const std::vector<float>& r = correlation.r;
      if (r[i] <= 0) continue;
      // The row above s = 0 has the values of -s.
      const auto above = [&](int dx) {
        return y > 0 ? r[i - columns + dx] : correlation.at(Vec2(x + dx, -1));
      };
      bool is_peak = r[i] > r[i - 1] && r[i] >= r[i + 1];
      for (int dx = -1; dx <= 1; ++dx)
        is_peak = is_peak && r[i] > above(dx) && r[i] >= r[i + columns + dx];
      if (!is_peak) continue;
      peaks.push_back(
          {Vec2(x + vertex(r[i - 1], r[i], r[i + 1]), y + vertex(above(0), r[i], r[i + columns])),
           r[i]});
    }
  }
  std::vector<double> keys(peaks.size());
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = -peaks[i].r;
  std::vector<CorrelationPeak> highest;
  for (const std::size_t i : placesInOrder(keys)) {
    if (highest.size() == kHighest) break;
    highest.push_back(peaks[i]);
  }
  keys.resize(highest.size());
  for (std::size_t i = 0; i < highest.size(); ++i) {
    double dominance = highest[i].at.squaredNorm();
    for (std::size_t j = 0; j < i; ++j) {
      dominance = std::min({dominance, (highest[i].at - highest[j].at).squaredNorm(),
                            (highest[i].at + highest[j].at).squaredNorm()});
    }
    keys[i] = -dominance;
  }
  std::vector<CorrelationPeak> dominant;
  for (const std::size_t i : placesInOrder(keys)) {
    if (static_cast<int>(dominant.size()) == most) break;
    dominant.push_back(highest[i]);
  }
  return dominant;
}

std::vector<VotedLattice> voteLattices(const Autocorrelation& correlation, double shortest,
                                       int most) {
  const auto peaks = dominantPeaks(correlation, shortest, kMostPeaks);
  std::vector<VotedLattice> lattices;
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto [a, b] = lagrangeReduced(peaks[i].at, peaks[j].at);
      if (a.norm() < shortest || std::abs(cross(a, b)) < kLeastAngle * a.norm() * b.norm())
        continue;
      const VotedLattice lattice = scored(correlation, a, b);
      if (lattice.score > 0) lattices.push_back(lattice);
    }
  }
  double best = 0;
  for (const auto& lattice : lattices) best = std::max(best, lattice.score);
  // The smallest cell among the good ones is the repeat itself, larger ones are its multiples.
  double smallest = 1e300;
  for (const auto& lattice : lattices)
    if (lattice.score > kGoodShare * best) smallest = std::min(smallest, areaOf(lattice));
  const auto rank = [&](const VotedLattice& lattice) {
    const bool is_good = lattice.score > kGoodShare * best;
    return -lattice.score - (is_good && areaOf(lattice) < 1.15 * smallest ? best : 0);
  };
  std::vector<double> keys(lattices.size());
  for (std::size_t k = 0; k < keys.size(); ++k) keys[k] = rank(lattices[k]);
  std::vector<VotedLattice> distinct;
  for (const std::size_t k : placesInOrder(keys)) {
    const VotedLattice& lattice = lattices[k];
    if (static_cast<int>(distinct.size()) == most) break;
    if (std::none_of(distinct.begin(), distinct.end(),
                     [&](const auto& other) { return isSame(lattice, other); }))
      distinct.push_back(lattice);
  }
  return distinct;
}

std::vector<VotedLattice> voteStripes(const Autocorrelation& correlation, double shortest) {
  constexpr int kDirections = 180;
  const double reach = 0.9 * std::min(correlation.reach_x, correlation.reach_y);
  double ridge = -1, direction = 0, lowest = 1;
  for (int k = 0; k < kDirections; ++k) {
    const Vec2 along = unit(kPi * k / kDirections);
    double least = 1;
    for (double t = shortest; t < reach; ++t) least = std::min(least, correlation.at(t * along));
    if (least > ridge) ridge = least, direction = kPi * k / kDirections;
    lowest = std::min(lowest, least);
  }
  double highest = 0;
  for (const auto& peak : dominantPeaks(correlation, shortest, kMostPeaks))
    highest = std::max(highest, peak.r);
  std::vector<VotedLattice> stripes;
  if (ridge < 0.1 || ridge < kRidge * highest || lowest > 0.3 * ridge) return stripes;
  const Vec2 across = perp(unit(direction));
  std::vector<double> profile;
  for (double t = 0; t < reach; ++t) profile.push_back(correlation.at(t * across));
  for (std::size_t t = static_cast<std::size_t>(shortest); t + 1 < profile.size(); ++t) {
    const bool is_peak = profile[t] > profile[t - 1] && profile[t] >= profile[t + 1];
    if (!is_peak || profile[t] < kRidge * ridge) continue;
    const double period =
        static_cast<double>(t) + vertex(profile[t - 1], profile[t], profile[t + 1]);
    const VotedLattice found{{period * across, period * unit(direction)}, profile[t], true};
    stripes.push_back(found);
    break;
  }
  return stripes;
}

}  // namespace seamwise
