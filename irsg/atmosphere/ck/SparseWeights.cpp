#include "irsg/atmosphere/ck/SparseWeights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "irsg/radiometry/Errors.h"

namespace irsg {

namespace {

double sumOfSquares(const std::vector<double>& values) {
    return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

double largest(const std::vector<double>& values) {
    double most = 0.0;
    for (const double value : values)
        most = std::max(most, std::abs(value));
    return most;
}

/// The columns in use with their products, which grow and shrink by one at a time.
class ActiveSet {
  public:
    explicit ActiveSet(const SparseProblem& problem) : problem_(problem) {}

    const std::vector<std::size_t>& columns() const { return columns_; }

    void add(std::size_t column) {
        columns_.push_back(column);
        std::vector<double> products;
        for (const std::size_t other : columns_)
            products.push_back(
                std::inner_product(data(column), data(column) + problem_.rows, data(other), 0.0));
        gram_.push_back(std::move(products));
        right_.push_back(std::inner_product(data(column), data(column) + problem_.rows,
                                            problem_.target.begin(), 0.0));
    }
    void remove(std::size_t place) {
        const auto at = static_cast<std::ptrdiff_t>(place);
        columns_.erase(columns_.begin() + at);
        right_.erase(right_.begin() + at);
        gram_.erase(gram_.begin() + at);
        for (std::size_t i = place; i < gram_.size(); ++i)
            gram_[i].erase(gram_[i].begin() + at);
    }
    /// Unconstrained least squares by Cholesky's decomposition; false where columns depend on each
    /// other.
    bool solve(std::vector<double>& weights) const {
        const std::size_t n = columns_.size();
        std::vector<std::vector<double>> factor(n);
        weights.assign(n, 0.0);
        for (std::size_t i = 0; i < n; ++i) {
            factor[i].resize(i + 1);
            for (std::size_t j = 0; j <= i; ++j) {
                double sum = gram_[i][j];
                for (std::size_t k = 0; k < j; ++k)
                    sum -= factor[i][k] * factor[j][k];
                if (i != j)
                    factor[i][j] = sum / factor[j][j];
                else if (sum <= 1e-11 * gram_[i][i])
                    return false;
                else
                    factor[i][i] = std::sqrt(sum);
            }
            double sum = right_[i];
            for (std::size_t k = 0; k < i; ++k)
                sum -= factor[i][k] * weights[k];
            weights[i] = sum / factor[i][i];
        }
        for (std::size_t i = n; i-- > 0;) {
            for (std::size_t k = i + 1; k < n; ++k)
                weights[i] -= factor[k][i] * weights[k];
            weights[i] /= factor[i][i];
        }
        return true;
    }
    std::vector<double> residual(const std::vector<double>& weights) const {
        std::vector<double> rest = problem_.target;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const float* column = data(columns_[i]);
            for (std::size_t r = 0; r < problem_.rows; ++r)
                rest[r] -= weights[i] * static_cast<double>(column[r]);
        }
        return rest;
    }

  private:
    const float* data(std::size_t column) const {
        return problem_.columns.data() + column * problem_.rows;
    }

    const SparseProblem& problem_;
    std::vector<std::size_t> columns_;
    std::vector<std::vector<double>> gram_; ///< lower triangle
    std::vector<double> right_;
};

/// 1 / length of every column, 0 for those that are nothing.
std::vector<float> inverseLengths(const SparseProblem& problem) {
    std::vector<float> inverse;
    for (std::size_t c = 0; c < problem.columnCount(); ++c) {
        const float* column = problem.columns.data() + c * problem.rows;
        const double square = std::inner_product(column, column + problem.rows, column, 0.0);
        inverse.push_back(square > 0.0 ? static_cast<float>(1.0 / std::sqrt(square)) : 0.0f);
    }
    return inverse;
}

/// The unused column whose direction lowers the residual most, or one past the last.
std::size_t steepest(const SparseProblem& problem, const std::vector<double>& rest,
                     const std::vector<char>& used, const std::vector<float>& inverse) {
    std::vector<float> direction(problem.rows);
    std::ranges::transform(rest, direction.begin(), [](double v) { return static_cast<float>(v); });
    std::size_t best = used.size();
    float bestSlope = 0.0f;
    for (std::size_t c = 0; c < used.size(); ++c) {
        if (used[c])
            continue;
        const float* column = problem.columns.data() + c * problem.rows;
        float slope = 0.0f;
        for (std::size_t r = 0; r < problem.rows; ++r)
            slope += column[r] * direction[r];
        slope *= inverse[c];
        if (slope > bestSlope) {
            bestSlope = slope;
            best = c;
        }
    }
    return best;
}

/// Moves the weights towards the unconstrained solution as far as all stay positive; what reaches
/// zero leaves the set. Gives the solution on the set that is left.
void descend(ActiveSet& active, std::vector<char>& used, std::vector<double>& weights,
             std::vector<double> trial) {
    while (std::ranges::any_of(trial, [](double w) { return w <= 0.0; })) {
        double step = 1.0;
        for (std::size_t i = 0; i < trial.size(); ++i)
            if (trial[i] <= 0.0)
                step = std::min(step, weights[i] / (weights[i] - trial[i]));
        for (std::size_t i = trial.size(); i-- > 0;) {
            weights[i] += step * (trial[i] - weights[i]);
            if (weights[i] <= 1e-14) {
                used[active.columns()[i]] = 0;
                active.remove(i);
                weights.erase(weights.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
        if (!active.solve(trial))
            return;
    }
    weights = std::move(trial);
}

} // namespace

SparseWeights sparseWeights(const SparseProblem& problem, double largestError, std::size_t most) {
    const std::size_t count = problem.columnCount();
    if (count == 0 || problem.target.size() != problem.rows)
        throw LogicError("terms were asked for where there are no candidates");
    const std::vector<float> inverse = inverseLengths(problem);
    std::vector<char> used(count, 0); // in the set, or found to say nothing new
    ActiveSet active(problem);
    std::vector<double> weights, rest = problem.target;

    constexpr std::size_t patience = 20;
    std::size_t fruitless = 0;
    while (largest(rest) > largestError && active.columns().size() < most && fruitless < patience) {
        const std::size_t next = steepest(problem, rest, used, inverse);
        if (next == count)
            break;
        used[next] = 1;
        active.add(next);
        std::vector<double> trial;
        if (!active.solve(trial)) {
            active.remove(active.columns().size() - 1);
            ++fruitless;
            continue;
        }
        weights.push_back(0.0);
        descend(active, used, weights, std::move(trial));
        std::vector<double> now = active.residual(weights);
        fruitless = sumOfSquares(now) < sumOfSquares(rest) * (1.0 - 1e-6) ? 0 : fruitless + 1;
        rest = std::move(now);
    }

    SparseWeights result;
    std::vector<std::size_t> order(weights.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::size_t i) { return active.columns()[i]; });
    for (const std::size_t i : order) {
        result.columns.push_back(active.columns()[i]);
        result.weights.push_back(weights[i]);
    }
    result.largestError = largest(rest);
    result.rmsError = std::sqrt(sumOfSquares(rest) / static_cast<double>(problem.rows));
    return result;
}

} // namespace irsg
