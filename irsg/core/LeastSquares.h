#pragma once

#include <cstddef>
#include <vector>

namespace irsg {

/// A matrix whose columns lie one behind the other.
class ColumnMatrix {
  public:
    ColumnMatrix(std::size_t rows, std::size_t columns)
        : rows_(rows), columns_(columns), values_(rows * columns, 0.0) {}

    std::size_t rows() const { return rows_; }
    std::size_t columns() const { return columns_; }
    double* column(std::size_t number) { return values_.data() + number * rows_; }
    const double* column(std::size_t number) const { return values_.data() + number * rows_; }
    double& at(std::size_t row, std::size_t column) { return values_[column * rows_ + row]; }
    double at(std::size_t row, std::size_t column) const { return values_[column * rows_ + row]; }

  private:
    std::size_t rows_, columns_;
    std::vector<double> values_;
};

/// The X that makes |A X - B|^2 + r^2 |N X|^2 least, where N holds the lengths of the columns of A:
/// one column for each of B, by reflections (A. S. Householder 1958, J. ACM 5, 339). `ridge`: r,
/// above 0, of which columns of A that depend on each other have small solutions. LogicError for
/// unlike numbers of rows.
ColumnMatrix leastSquares(const ColumnMatrix& a, const ColumnMatrix& b, double ridge);

} // namespace irsg
