#include "irsg/atmosphere/ck/ActiveSet.h"

#include <array>
#include <numeric>

#include "irsg/core/VectorClones.h"
#include "irsg/radiometry/DotProducts.h"

namespace irsg {

namespace {

constexpr std::size_t lanes = 16; ///< sums that run side by side, so that compilers make vectors

IRSG_VECTOR_CLONES double dotProduct(const float* a, const float* b, std::size_t n) {
    std::array<double, lanes> sums{};
    std::size_t r = 0;
    for (; r + lanes <= n; r += lanes)
        for (std::size_t k = 0; k < lanes; ++k)
            sums[k] += static_cast<double>(a[r + k]) * static_cast<double>(b[r + k]);
    for (; r < n; ++r)
        sums[0] += static_cast<double>(a[r]) * static_cast<double>(b[r]);
    return sumOf(sums);
}

IRSG_VECTOR_CLONES double coarseSum(const float* a, const float* b, std::size_t n) {
    std::array<float, lanes> sums{};
    std::size_t r = 0;
    for (; r + lanes <= n; r += lanes)
        for (std::size_t k = 0; k < lanes; ++k)
            sums[k] += a[r + k] * b[r + k];
    for (; r < n; ++r)
        sums[0] += a[r] * b[r];
    return sumOf(sums);
}

IRSG_VECTOR_CLONES double dotProduct(const double* a, const float* b, std::size_t n) {
    std::array<double, lanes> sums{};
    std::size_t k = 0;
    for (; k + lanes <= n; k += lanes)
        for (std::size_t i = 0; i < lanes; ++i)
            sums[i] += a[k + i] * static_cast<double>(b[k + i]);
    for (; k < n; ++k)
        sums[0] += a[k] * static_cast<double>(b[k]);
    return sumOf(sums);
}

IRSG_VECTOR_CLONES void subtract(double weight, const float* column, std::size_t n, double* rest) {
    for (std::size_t r = 0; r < n; ++r)
        rest[r] -= weight * static_cast<double>(column[r]);
}

/// Adds four rows with their weights to a fifth.
IRSG_VECTOR_CLONES void addFour(const std::array<double, 4>& weights,
                                const std::array<const double*, 4>& rows, std::size_t n,
                                double* __restrict sum) {
    const double a = weights[0], b = weights[1], c = weights[2], d = weights[3];
    const double *ofA = rows[0], *ofB = rows[1], *ofC = rows[2], *ofD = rows[3];
    for (std::size_t i = 0; i < n; ++i)
        sum[i] += (a * ofA[i] + b * ofB[i]) + (c * ofC[i] + d * ofD[i]);
}

IRSG_VECTOR_CLONES void subtractScaled(double factor, const double* a, std::size_t n, double* b) {
    for (std::size_t i = 0; i < n; ++i)
        b[i] -= factor * a[i];
}

} // namespace

double product(const float* a, const float* b, std::size_t n) {
    return dotProduct(a, b, n);
}

double product(const double* a, const float* b, std::size_t n) {
    return dotProduct(a, b, n);
}

double product(const double* a, const double* b, std::size_t n) {
    return dotProduct(a, b, n);
}

double coarseProduct(const float* a, const float* b, std::size_t n) {
    return coarseSum(a, b, n);
}

double largest(const std::vector<double>& values) {
    double most = 0.0;
    for (const double value : values)
        most = std::max(most, std::abs(value));
    return most;
}

SomeRows::SomeRows(const SparseProblem& all, const std::vector<std::size_t>& which)
    : rows(which.size()), columnCount(all.columnCount), columns(rows * columnCount) {
    for (std::size_t first = 0; first < rows; first += lanes) {
        const std::size_t last = std::min(first + lanes, rows);
        for (std::size_t c = 0; c < columnCount; ++c)
            for (std::size_t r = first; r < last; ++r)
                columns[c * rows + r] = all.row(which[r])[c];
    }
    for (const std::size_t r : which)
        target.push_back(all.target[r]);
}

ActiveSet::ActiveSet(const SomeRows& problem)
    : problem_(&problem), importance_(problem.rows, 1.0f) {
    for (const double value : problem.target)
        target_.push_back(static_cast<float>(value));
}

ActiveSet::ActiveSet(const SomeRows& problem, const ActiveSet& before) : ActiveSet(problem) {
    std::ranges::copy(before.importance_, importance_.begin());
    add(before.columns_);
    weights_ = before.weights_;
}

void ActiveSet::add(const std::vector<std::size_t>& columns) {
    const std::size_t first = columns_.size();
    columns_.insert(columns_.end(), columns.begin(), columns.end());
    weights_.resize(columns_.size(), 0.0);
    appendProducts(first);
}

void ActiveSet::remove(std::size_t place) {
    const auto at = static_cast<std::ptrdiff_t>(place);
    columns_.erase(columns_.begin() + at);
    weights_.erase(weights_.begin() + at);
    right_.erase(right_.begin() + at);
    std::size_t to = row(place); // what stays moves up
    for (std::size_t i = place + 1; i <= columns_.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
            if (j != place)
                gram_[to++] = gram_[row(i) + j];
    gram_.resize(to);
    factored_ = std::min(factored_, place);
}

void ActiveSet::emphasize(const std::vector<double>& rest) {
    const double perLargest = 1.0 / std::max(largest(rest), 1e-30);
    double sum = 0.0;
    for (std::size_t r = 0; r < rest.size(); ++r) {
        constexpr double least = 0.02;
        importance_[r] *= static_cast<float>(std::abs(rest[r]) * perLargest + least);
        sum += static_cast<double>(importance_[r]);
    }
    const auto scale = static_cast<float>(static_cast<double>(rest.size()) / sum);
    for (float& value : importance_)
        value = std::max(value * scale, 1e-6f);
    gram_.clear();
    right_.clear();
    factored_ = 0;
    appendProducts(0);
}

bool ActiveSet::solve() {
    for (;;) {
        if (!decompose())
            return false;
        const std::vector<double> trial = solution();
        bool isInside = true;
        // What is new and would be negative goes at once.
        for (std::size_t i = trial.size(); i-- > 0;)
            if (trial[i] <= 0.0 && weights_[i] == 0.0) {
                isInside = false;
                remove(i);
            }
        if (!isInside)
            continue;
        double step = 1.0;
        for (std::size_t i = 0; i < trial.size(); ++i)
            if (trial[i] <= 0.0)
                step = std::min(step, weights_[i] / (weights_[i] - trial[i]));
        for (std::size_t i = trial.size(); i-- > 0;) {
            isInside = isInside && trial[i] > 0.0;
            weights_[i] += step * (trial[i] - weights_[i]);
            if (weights_[i] <= 1e-14)
                remove(i);
        }
        if (isInside)
            return true;
    }
}

std::vector<double> ActiveSet::residual() const {
    std::vector<double> rest = problem_->target;
    for (std::size_t i = 0; i < weights_.size(); ++i)
        subtract(weights_[i], problem_->column(columns_[i]), problem_->rows, rest.data());
    return rest;
}

std::vector<std::size_t> ActiveSet::dispensable() {
    decompose();
    const std::size_t n = size();
    std::vector<double> cost(n), column(n);
    for (std::size_t k = 0; k < n; ++k) {
        double inverse = 0.0; // of the Gram matrix: squares of a column of the inverse factor
        for (std::size_t i = k; i < n; ++i) {
            double sum = i == k ? 1.0 : 0.0;
            for (std::size_t j = k; j < i; ++j)
                sum -= factor_[row(i) + j] * column[j];
            column[i] = sum / factor_[row(i) + i];
            inverse += column[i] * column[i];
        }
        cost[k] = weights_[k] * weights_[k] / inverse;
    }
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::size_t i) { return cost[i]; });
    return order;
}

void ActiveSet::appendProducts(std::size_t first) {
    const std::size_t n = columns_.size(), rows = problem_->rows;
    // Row by row of the problem, as many numbers as there are columns in the set, and none beyond.
    std::vector<double> values(n * ((rows + 3) / 4) * 4, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        const float* own = problem_->column(columns_[i]);
        for (std::size_t r = 0; r < rows; ++r)
            values[r * n + i] = static_cast<double>(own[r]);
    }
    gram_.resize(row(n));
    std::fill(gram_.begin() + static_cast<std::ptrdiff_t>(row(first)), gram_.end(), 0.0);
    right_.resize(n, 0.0);
    for (std::size_t r = 0; r < rows; r += 4) {
        const double* at = values.data() + r * n; // none where the set is empty
        std::array<double, 4> importance{};
        for (std::size_t k = 0; k < 4 && r + k < rows; ++k) {
            importance[k] = static_cast<double>(importance_[r + k]);
            const double target = importance[k] * problem_->target[r + k];
            for (std::size_t i = first; i < n; ++i)
                right_[i] += target * at[k * n + i];
        }
        for (std::size_t i = first; i < n; ++i)
            addFour({importance[0] * at[i], importance[1] * at[n + i],
                     importance[2] * at[2 * n + i], importance[3] * at[3 * n + i]},
                    {at, at + n, at + 2 * n, at + 3 * n}, i + 1, &gram_[row(i)]);
    }
}

/// Cholesky's, from the first row that is not done yet.
bool ActiveSet::decompose() {
    const std::size_t n = columns_.size();
    factor_.resize(row(n));
    for (std::size_t i = factored_; i < n; ++i) {
        double* own = &factor_[row(i)];
        for (std::size_t j = 0; j <= i; ++j) {
            const double* other = &factor_[row(j)];
            const double sum = gram_[row(i) + j] - dotProduct(own, other, j);
            if (i != j)
                own[j] = sum / other[j];
            else if (sum <= 1e-11 * gram_[row(i) + i])
                return false;
            else
                own[i] = std::sqrt(sum);
        }
        factored_ = i + 1;
    }
    return true;
}

std::vector<double> ActiveSet::solution() const {
    const std::size_t n = columns_.size();
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i)
        x[i] = (right_[i] - dotProduct(&factor_[row(i)], x.data(), i)) / factor_[row(i) + i];
    for (std::size_t i = n; i-- > 0;) { // by rows of the factor, as they lie
        x[i] /= factor_[row(i) + i];
        subtractScaled(x[i], &factor_[row(i)], i, x.data());
    }
    return x;
}

} // namespace irsg
