#include "recognition/symmetry/square_fourier.h"

#include <unsupported/Eigen/FFT>

namespace seamwise {
namespace {

void transposeSquare(std::vector<ComplexFloat>& values, int n) {
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < j; ++i) std::swap(values[j * n + i], values[i * n + j]);
  }
}

}  // namespace

void squareFourier(std::vector<ComplexFloat>& values, int n, bool inverse) {
  Eigen::FFT<float> transform;
  transform.SetFlag(Eigen::FFT<float>::Unscaled);
  std::vector<ComplexFloat> row(n);
  for (int pass = 0; pass < 2; ++pass) {
    for (int j = 0; j < n; ++j) {
      ComplexFloat* const at = values.data() + static_cast<std::size_t>(j) * n;
      if (inverse) {
        transform.inv(row.data(), at, n);
      } else {
        transform.fwd(row.data(), at, n);
      }
      std::copy(row.begin(), row.end(), at);
    }
    transposeSquare(values, n);
  }
}

}  // namespace seamwise
