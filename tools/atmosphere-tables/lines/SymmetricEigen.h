#pragma once

#include <cstddef>
#include <vector>

namespace irsg::lbl {

/// A square matrix, row after row.
class SquareMatrix {
  public:
    explicit SquareMatrix(std::size_t size) : size_(size), values_(size * size, 0.0) {}

    std::size_t size() const { return size_; }
    double& operator()(std::size_t row, std::size_t column) {
        return values_[row * size_ + column];
    }
    double operator()(std::size_t row, std::size_t column) const {
        return values_[row * size_ + column];
    }

  private:
    std::size_t size_;
    std::vector<double> values_;
};

/// Eigenvalues, ascending, and the eigenvector of each, of length 1.
struct EigenSystem {
    std::vector<double> values;
    std::vector<std::vector<double>> vectors;
};

/// Of a symmetric matrix, by cyclic rotations (Jacobi 1846): slow beyond some hundred rows, but
/// each value is right to the last digits. LogicError where the matrix has a value that is not
/// finite.
EigenSystem eigenSystem(SquareMatrix matrix);

} // namespace irsg::lbl
