#include "irsg/atmosphere/ck/ActiveSet.h"

#include <array>
#include <numeric>

#include "irsg/radiometry/VectorClones.h"

namespace irsg {

namespace {

constexpr std::size_t lanes = 16; ///< sums that run side by side, so that compilers make vectors

template <typename Number>
double sumOf(const std::array<Number, lanes>& sums) {
    double all = 0.0;
    for (const Number sum : sums)
        all += static_cast<double>(sum);
    return all;
}

IRSG_VECTOR_CLONES double sumOfProducts(const float* a, const float* b, std::size_t n) {
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

/// Sum of products of the first n.
IRSG_VECTOR_CLONES double sumOfProducts(const double* a, const double* b, std::size_t n) {
    std::array<double, lanes> sums{};
    std::size_t k = 0;
    for (; k + lanes <= n; k += lanes)
        for (std::size_t i = 0; i < lanes; ++i)
            sums[i] += a[k + i] * b[k + i];
    for (; k < n; ++k)
        sums[0] += a[k] * b[k];
    return sumOf(sums);
}

IRSG_VECTOR_CLONES double sumOfProducts(const double* a, const float* b, std::size_t n) {
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

} // namespace

double product(const float* a, const float* b, std::size_t n) {
    return sumOfProducts(a, b, n);
}

double product(const double* a, const float* b, std::size_t n) {
    return sumOfProducts(a, b, n);
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
    for (const std::size_t column : before.columns_)
        add(column);
    weights_ = before.weights_;
}

void ActiveSet::add(std::size_t column) {
    columns_.push_back(column);
    weights_.push_back(0.0);
    appendProducts(columns_.size() - 1);
}

void ActiveSet::remove(std::size_t place) {
    const auto at = static_cast<std::ptrdiff_t>(place);
    columns_.erase(columns_.begin() + at);
    weights_.erase(weights_.begin() + at);
    right_.erase(right_.begin() + at);
    gram_.erase(gram_.begin() + at);
    for (std::size_t i = place; i < gram_.size(); ++i)
        gram_[i].erase(gram_[i].begin() + at);
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
    for (std::size_t i = 0; i < columns_.size(); ++i)
        appendProducts(i);
}

bool ActiveSet::solve() {
    for (;;) {
        if (!decompose())
            return false;
        const std::vector<double> trial = solution();
        double step = 1.0;
        for (std::size_t i = 0; i < trial.size(); ++i)
            if (trial[i] <= 0.0)
                step = std::min(step, weights_[i] / (weights_[i] - trial[i]));
        bool isInside = true;
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
    std::vector<double> cost(n), row(n);
    for (std::size_t k = 0; k < n; ++k) {
        double inverse = 0.0; // of the Gram matrix: squares of a column of the inverse factor
        for (std::size_t i = k; i < n; ++i) {
            double sum = i == k ? 1.0 : 0.0;
            for (std::size_t j = k; j < i; ++j)
                sum -= factor_[i][j] * row[j];
            row[i] = sum / factor_[i][i];
            inverse += row[i] * row[i];
        }
        cost[k] = weights_[k] * weights_[k] / inverse;
    }
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::size_t i) { return cost[i]; });
    return order;
}

void ActiveSet::appendProducts(std::size_t place) {
    const float* own = problem_->column(columns_[place]);
    std::vector<float> weighted(problem_->rows);
    for (std::size_t r = 0; r < weighted.size(); ++r)
        weighted[r] = own[r] * importance_[r];
    std::vector<double> products;
    for (std::size_t i = 0; i <= place; ++i)
        products.push_back(product(weighted.data(), problem_->column(columns_[i]), problem_->rows));
    gram_.push_back(std::move(products));
    right_.push_back(product(weighted.data(), target_.data(), problem_->rows));
}

/// Cholesky's, from the first row that is not done yet.
bool ActiveSet::decompose() {
    const std::size_t n = columns_.size();
    factor_.resize(n);
    for (std::size_t i = factored_; i < n; ++i) {
        factor_[i].resize(i + 1);
        for (std::size_t j = 0; j <= i; ++j) {
            const double sum = gram_[i][j] - sumOfProducts(factor_[i].data(), factor_[j].data(), j);
            if (i != j)
                factor_[i][j] = sum / factor_[j][j];
            else if (sum <= 1e-11 * gram_[i][i])
                return false;
            else
                factor_[i][i] = std::sqrt(sum);
        }
        factored_ = i + 1;
    }
    return true;
}

std::vector<double> ActiveSet::solution() const {
    const std::size_t n = columns_.size();
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i)
        x[i] = (right_[i] - sumOfProducts(factor_[i].data(), x.data(), i)) / factor_[i][i];
    for (std::size_t i = n; i-- > 0;) { // by rows of the factor, as they lie
        x[i] /= factor_[i][i];
        for (std::size_t k = 0; k < i; ++k)
            x[k] -= factor_[i][k] * x[i];
    }
    return x;
}

} // namespace irsg
