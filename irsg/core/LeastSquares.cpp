#include "irsg/core/LeastSquares.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

double product(const double* a, const double* b, std::size_t first, std::size_t last) {
    double sum = 0.0;
    for (std::size_t i = first; i < last; ++i)
        sum += a[i] * b[i];
    return sum;
}

/// Takes a column less `part` of another, from a row on.
void subtract(const double* other, double part, double* column, std::size_t first,
              std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
        column[i] -= part * other[i];
}

/// The matrix with `more` rows of zeros below it.
ColumnMatrix withRows(const ColumnMatrix& matrix, std::size_t more) {
    ColumnMatrix longer(matrix.rows() + more, matrix.columns());
    for (std::size_t k = 0; k < matrix.columns(); ++k)
        std::copy_n(matrix.column(k), matrix.rows(), longer.column(k));
    return longer;
}

} // namespace

ColumnMatrix leastSquares(const ColumnMatrix& a, const ColumnMatrix& b, double ridge) {
    if (a.rows() != b.rows())
        throw LogicError("least squares of matrices with unlike numbers of rows");
    const std::size_t unknowns = a.columns(), rows = a.rows() + unknowns;
    ColumnMatrix left = withRows(a, unknowns), right = withRows(b, unknowns);
    std::vector<double> lengths(unknowns);
    for (std::size_t k = 0; k < unknowns; ++k) {
        double* column = left.column(k);
        lengths[k] = std::sqrt(product(column, column, 0, rows));
        for (std::size_t i = 0; i < a.rows() && lengths[k] > 0.0; ++i)
            column[i] /= lengths[k];
        column[a.rows() + k] = ridge;
    }
    std::vector<double> mirror(rows);
    for (std::size_t k = 0; k < unknowns; ++k) {
        double* column = left.column(k);
        const double size = std::sqrt(product(column, column, k, rows));
        const double diagonal = column[k] > 0.0 ? -size : size;
        std::copy(column + k, column + rows, mirror.begin() + static_cast<std::ptrdiff_t>(k));
        mirror[k] -= diagonal;
        const double square = product(mirror.data(), mirror.data(), k, rows);
        const auto reflect = [&](double* other) {
            const double part = 2.0 / square * product(mirror.data(), other, k, rows);
            subtract(mirror.data(), part, other, k, rows);
        };
        for (std::size_t other = k; other < unknowns; ++other)
            reflect(left.column(other));
        for (std::size_t other = 0; other < right.columns(); ++other)
            reflect(right.column(other));
    }
    ColumnMatrix x(unknowns, right.columns());
    for (std::size_t c = 0; c < right.columns(); ++c)
        for (std::size_t k = unknowns; k-- > 0;) {
            double rest = right.at(k, c);
            for (std::size_t other = k + 1; other < unknowns; ++other)
                rest -= left.at(k, other) * x.at(other, c);
            x.at(k, c) = rest / left.at(k, k);
        }
    for (std::size_t c = 0; c < x.columns(); ++c)
        for (std::size_t k = 0; k < unknowns; ++k)
            x.at(k, c) = lengths[k] > 0.0 ? x.at(k, c) / lengths[k] : 0.0;
    return x;
}

} // namespace irsg
