#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "irsg/atmosphere/ck/SparseWeights.h"

namespace irsg {

/// Some rows of a problem, column by column.
struct SomeRows {
    std::size_t rows = 0, columnCount = 0;
    std::vector<float> columns;
    std::vector<double> target;

    SomeRows(const SparseProblem& all, const std::vector<std::size_t>& which);
    const float* column(std::size_t c) const { return columns.data() + c * rows; }
};

/// Sum of products in double, in single precision, and the largest magnitude.
double product(const float* a, const float* b, std::size_t n);
double product(const double* a, const float* b, std::size_t n);
double product(const double* a, const double* b, std::size_t n);
double coarseProduct(const float* a, const float* b, std::size_t n);
double largest(const std::vector<double>& values);

/// Least squares with weighted rows over a set of columns that grows and shrinks. Refers to the
/// rows.
class ActiveSet {
  public:
    explicit ActiveSet(const SomeRows& problem);
    /// The columns and weights of a set over fewer rows, which are the first of these.
    ActiveSet(const SomeRows& problem, const ActiveSet& before);

    const std::vector<std::size_t>& columns() const { return columns_; }
    const std::vector<double>& weights() const { return weights_; }
    const std::vector<float>& importance() const { return importance_; }
    std::size_t size() const { return columns_.size(); }

    void add(const std::vector<std::size_t>& columns);
    void remove(std::size_t place);
    /// Makes rows count more the larger their errors are.
    void emphasize(const std::vector<double>& rest);
    /// Solves for weights that are not negative, from those at hand: they move towards the
    /// unconstrained solution as far as all stay positive, and what reaches zero leaves the set.
    /// False where a column depends on the others.
    bool solve();
    /// The place of that column after `solve` failed.
    std::size_t dependent() const { return factored_; }
    std::vector<double> residual() const;
    /// Places in the set, from the column whose loss raises the sum of squares least: by
    /// weight^2 / (Gram^-1)_ii.
    std::vector<std::size_t> dispensable();

  private:
    /// Where a row of a triangle begins.
    static std::size_t row(std::size_t place) { return place * (place + 1) / 2; }
    void appendProducts(std::size_t first);
    bool decompose();
    std::vector<double> solution() const;

    const SomeRows* problem_;
    std::vector<float> importance_; ///< of the rows, mean 1
    std::vector<float> target_;
    std::vector<std::size_t> columns_;
    std::vector<double> weights_;
    std::vector<double> gram_, factor_; ///< lower triangles, row by row
    std::size_t factored_ = 0;          ///< rows of the factor that are those of the Gram matrix
    std::vector<double> right_;
};

} // namespace irsg
