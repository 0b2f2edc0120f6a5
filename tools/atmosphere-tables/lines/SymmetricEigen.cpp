#include "tools/atmosphere-tables/lines/SymmetricEigen.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "irsg/core/Errors.h"

namespace irsg::lbl {

EigenSystem eigenSystem(SquareMatrix matrix) {
    const std::size_t n = matrix.size();
    double total = 0.0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            total += matrix(i, j) * matrix(i, j);
    if (!std::isfinite(total))
        throw LogicError("the eigenvalues of a matrix with a value that is not finite were asked");

    std::vector<std::vector<double>> vectors(n, std::vector<double>(n, 0.0)); // columns, by row
    for (std::size_t i = 0; i < n; ++i)
        vectors[i][i] = 1.0;
    constexpr int mostSweeps = 60;
    for (int sweep = 0; sweep < mostSweeps; ++sweep) {
        double outside = 0.0;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i + 1; j < n; ++j)
                outside += matrix(i, j) * matrix(i, j);
        if (outside <= 1e-30 * total)
            break;
        for (std::size_t p = 0; p + 1 < n; ++p)
            for (std::size_t q = p + 1; q < n; ++q) {
                const double off = matrix(p, q);
                if (off * off <= 1e-36 * total)
                    continue;
                const double theta = (matrix(q, q) - matrix(p, p)) / (2.0 * off);
                const double t =
                    (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::hypot(1.0, theta));
                const double c = 1.0 / std::hypot(1.0, t), s = t * c;
                for (std::size_t k = 0; k < n; ++k) {
                    const double a = matrix(p, k), b = matrix(q, k);
                    matrix(p, k) = c * a - s * b;
                    matrix(q, k) = s * a + c * b;
                }
                for (std::size_t k = 0; k < n; ++k) {
                    const double a = matrix(k, p), b = matrix(k, q);
                    matrix(k, p) = c * a - s * b;
                    matrix(k, q) = s * a + c * b;
                }
                for (std::size_t k = 0; k < n; ++k) {
                    const double a = vectors[p][k], b = vectors[q][k];
                    vectors[p][k] = c * a - s * b;
                    vectors[q][k] = s * a + c * b;
                }
            }
    }
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return matrix(i, i); });
    EigenSystem result;
    for (const std::size_t i : order) {
        result.values.push_back(matrix(i, i));
        result.vectors.push_back(std::move(vectors[i]));
    }
    return result;
}

} // namespace irsg::lbl
