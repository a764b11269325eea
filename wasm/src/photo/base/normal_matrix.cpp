#include "photo/base/normal_matrix.h"

#include <cmath>

namespace seamwise {

bool invertNormal(const NormalMatrix& a, int n, NormalMatrix& inverse) {
  NormalMatrix l{};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      double sum = a[i][j];
      for (int k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
      if (i == j) {
        if (!(sum > 1e-13 * a[i][i])) return false;
        l[i][i] = std::sqrt(sum);
      } else {
        l[i][j] = sum / l[j][j];
      }
    }
  }
  for (int column = 0; column < n; ++column) {
    std::array<double, kMostUnknowns> x{};
    for (int i = column; i < n; ++i) {
      double sum = i == column ? 1 : 0;
      for (int k = column; k < i; ++k) sum -= l[i][k] * x[k];
      x[i] = sum / l[i][i];
    }
    for (int i = n - 1; i >= 0; --i) {
      double sum = x[i];
      for (int k = i + 1; k < n; ++k) sum -= l[k][i] * inverse[k][column];
      inverse[i][column] = sum / l[i][i];
    }
  }
  return true;
}

}  // namespace seamwise
