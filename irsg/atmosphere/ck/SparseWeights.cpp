#include "irsg/atmosphere/ck/SparseWeights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "irsg/radiometry/Errors.h"
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

IRSG_VECTOR_CLONES double product(const float* a, const float* b, std::size_t n) {
    std::array<double, lanes> sums{};
    std::size_t r = 0;
    for (; r + lanes <= n; r += lanes)
        for (std::size_t k = 0; k < lanes; ++k)
            sums[k] += static_cast<double>(a[r + k]) * static_cast<double>(b[r + k]);
    for (; r < n; ++r)
        sums[0] += static_cast<double>(a[r]) * static_cast<double>(b[r]);
    return sumOf(sums);
}

IRSG_VECTOR_CLONES double coarseProduct(const float* a, const float* b, std::size_t n) {
    std::array<float, lanes> sums{};
    std::size_t r = 0;
    for (; r + lanes <= n; r += lanes)
        for (std::size_t k = 0; k < lanes; ++k)
            sums[k] += a[r + k] * b[r + k];
    for (; r < n; ++r)
        sums[0] += a[r] * b[r];
    return sumOf(sums);
}

IRSG_VECTOR_CLONES void subtract(double weight, const float* column, std::size_t n, double* rest) {
    for (std::size_t r = 0; r < n; ++r)
        rest[r] -= weight * static_cast<double>(column[r]);
}

double largest(const std::vector<double>& values) {
    double most = 0.0;
    for (const double value : values)
        most = std::max(most, std::abs(value));
    return most;
}

/// Least squares with weighted rows over a set of columns that grows and shrinks.
class ActiveSet {
  public:
    explicit ActiveSet(const SparseProblem& problem)
        : problem_(&problem), importance_(problem.rows, 1.0f) {
        for (const double value : problem.target)
            target_.push_back(static_cast<float>(value));
    }

    const std::vector<std::size_t>& columns() const { return columns_; }
    const std::vector<double>& weights() const { return weights_; }
    const std::vector<float>& importance() const { return importance_; }
    std::size_t size() const { return columns_.size(); }

    void add(std::size_t column) {
        columns_.push_back(column);
        weights_.push_back(0.0);
        appendProducts(columns_.size() - 1);
    }
    void remove(std::size_t place) {
        const auto at = static_cast<std::ptrdiff_t>(place);
        columns_.erase(columns_.begin() + at);
        weights_.erase(weights_.begin() + at);
        right_.erase(right_.begin() + at);
        gram_.erase(gram_.begin() + at);
        for (std::size_t i = place; i < gram_.size(); ++i)
            gram_[i].erase(gram_[i].begin() + at);
    }
    /// Makes rows count more the larger their errors are.
    void emphasize(const std::vector<double>& rest) {
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
        for (std::size_t i = 0; i < columns_.size(); ++i)
            appendProducts(i);
    }
    /// Solves for weights that are not negative, from those at hand: they move towards the
    /// unconstrained solution as far as all stay positive, and what reaches zero leaves the set.
    /// False where a column depends on the others.
    bool solve() {
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
    std::vector<double> residual() const {
        std::vector<double> rest = problem_->target;
        for (std::size_t i = 0; i < weights_.size(); ++i)
            subtract(weights_[i], data(columns_[i]), problem_->rows, rest.data());
        return rest;
    }
    /// Places in the set, from the column whose loss raises the sum of squares least: by
    /// weight^2 / (Gram^-1)_ii.
    std::vector<std::size_t> dispensable() {
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

  private:
    const float* data(std::size_t column) const {
        return problem_->columns.data() + column * problem_->rows;
    }
    void appendProducts(std::size_t place) {
        const float* own = data(columns_[place]);
        std::vector<float> weighted(problem_->rows);
        for (std::size_t r = 0; r < weighted.size(); ++r)
            weighted[r] = own[r] * importance_[r];
        std::vector<double> products;
        for (std::size_t i = 0; i <= place; ++i)
            products.push_back(product(weighted.data(), data(columns_[i]), problem_->rows));
        gram_.push_back(std::move(products));
        right_.push_back(product(weighted.data(), target_.data(), problem_->rows));
    }
    /// Cholesky's.
    bool decompose() {
        const std::size_t n = columns_.size();
        factor_.assign(n, {});
        for (std::size_t i = 0; i < n; ++i) {
            factor_[i].resize(i + 1);
            for (std::size_t j = 0; j <= i; ++j) {
                double sum = gram_[i][j];
                for (std::size_t k = 0; k < j; ++k)
                    sum -= factor_[i][k] * factor_[j][k];
                if (i != j)
                    factor_[i][j] = sum / factor_[j][j];
                else if (sum <= 1e-11 * gram_[i][i])
                    return false;
                else
                    factor_[i][i] = std::sqrt(sum);
            }
        }
        return true;
    }
    std::vector<double> solution() const {
        const std::size_t n = columns_.size();
        std::vector<double> x(n);
        for (std::size_t i = 0; i < n; ++i) {
            double sum = right_[i];
            for (std::size_t k = 0; k < i; ++k)
                sum -= factor_[i][k] * x[k];
            x[i] = sum / factor_[i][i];
        }
        for (std::size_t i = n; i-- > 0;) {
            for (std::size_t k = i + 1; k < n; ++k)
                x[i] -= factor_[k][i] * x[k];
            x[i] /= factor_[i][i];
        }
        return x;
    }

    const SparseProblem* problem_;
    std::vector<float> importance_; ///< of the rows, mean 1
    std::vector<float> target_;
    std::vector<std::size_t> columns_;
    std::vector<double> weights_;
    std::vector<std::vector<double>> gram_, factor_; ///< lower triangles
    std::vector<double> right_;
};

/// A set and how far it is from the target.
struct Fit {
    ActiveSet set;
    std::vector<double> rest;
    double error;

    explicit Fit(ActiveSet active)
        : set(std::move(active)), rest(set.residual()), error(largest(rest)) {}
};

/// Lawson's iteration towards the least largest error; the best of a few passes.
Fit levelled(ActiveSet set, int passes) {
    Fit best(std::move(set));
    Fit now = best;
    for (int pass = 0; pass < passes; ++pass) {
        now.set.emphasize(now.rest);
        if (!now.set.solve())
            break;
        now = Fit(std::move(now.set));
        if (now.error < best.error)
            best = now;
    }
    return best;
}

/// Finds columns to add.
class Candidates {
  public:
    explicit Candidates(const SparseProblem& problem)
        : problem_(problem), used_(problem.columnCount(), 0) {
        for (std::size_t c = 0; c < problem.columnCount(); ++c) {
            const double square = product(column(c), column(c), problem.rows);
            perLength_.push_back(square > 0.0 ? 1.0 / std::sqrt(square) : 0.0);
        }
    }
    void refuse(std::size_t column) { refused_.push_back(column); }

    /// The unused column whose direction lowers the residual most, or one past the last.
    std::size_t steepest(const Fit& fit) {
        std::ranges::fill(used_, 0);
        for (const std::size_t c : fit.set.columns())
            used_[c] = 1;
        for (const std::size_t c : refused_)
            used_[c] = 1;
        std::vector<float> direction(problem_.rows);
        for (std::size_t r = 0; r < direction.size(); ++r)
            direction[r] = static_cast<float>(fit.rest[r]) * fit.set.importance()[r];
        std::size_t best = used_.size();
        double bestSlope = 0.0;
        for (std::size_t c = 0; c < used_.size(); ++c) {
            if (used_[c])
                continue;
            const double slope =
                coarseProduct(column(c), direction.data(), problem_.rows) * perLength_[c];
            if (slope > bestSlope) {
                bestSlope = slope;
                best = c;
            }
        }
        return best;
    }

  private:
    const float* column(std::size_t c) const { return problem_.columns.data() + c * problem_.rows; }

    const SparseProblem& problem_;
    std::vector<double> perLength_;
    std::vector<char> used_;
    std::vector<std::size_t> refused_; ///< they say nothing new
};

/// Adds terms until no row's error is above `largestError`, `most` are in use or none helps.
Fit grown(const SparseProblem& problem, double largestError, std::size_t most) {
    // A fit that is stuck comes loose as a rule: some sets need a hundred terms more for it.
    constexpr int patience = 250;
    Candidates candidates(problem);
    Fit fit{ActiveSet(problem)};
    Fit best = fit;
    int fruitless = 0;
    std::size_t levelledAt = 0;
    while (best.error > largestError && fit.set.size() < most && fruitless < patience) {
        const std::size_t next = candidates.steepest(fit);
        if (next == problem.columnCount())
            break;
        ActiveSet with = fit.set;
        with.add(next);
        if (!with.solve()) {
            candidates.refuse(next);
            ++fruitless;
            continue;
        }
        fit = Fit(std::move(with));
        if (fit.set.size() >= levelledAt + 1 + levelledAt / 16) {
            levelledAt = fit.set.size();
            fit = levelled(std::move(fit.set), 1);
        }
        fruitless = fit.error < best.error ? 0 : fruitless + 1;
        if (fit.error < best.error)
            best = fit;
    }
    return best;
}

/// Takes terms out as long as the error stays within the bound.
Fit pruned(Fit fit, double largestError) {
    constexpr int passes = 6, attempts = 3;
    fit = levelled(std::move(fit.set), passes);
    for (bool isFinished = false; !isFinished;) {
        isFinished = true;
        const std::vector<std::size_t> order = fit.set.dispensable();
        // Many at once while there is room, then one by one.
        const bool isFar = fit.error < 0.7 * largestError;
        const std::size_t many = isFar ? fit.set.size() / 16 : 0;
        for (int attempt = many > 1 ? 0 : 1; attempt <= attempts && isFinished; ++attempt) {
            const auto at = static_cast<std::size_t>(attempt);
            std::vector<std::size_t> places;
            if (attempt == 0)
                places.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(many));
            else if (at <= order.size())
                places = {order[at - 1]};
            if (places.empty() || places.size() >= fit.set.size())
                continue;
            std::ranges::sort(places, std::ranges::greater());
            ActiveSet fewer = fit.set;
            for (const std::size_t place : places)
                fewer.remove(place);
            if (!fewer.solve())
                continue;
            Fit trial = levelled(std::move(fewer), passes);
            if (trial.error <= largestError) {
                fit = std::move(trial);
                isFinished = false;
            }
        }
    }
    return fit;
}

} // namespace

SparseWeights sparseWeights(const SparseProblem& problem, double largestError, std::size_t most) {
    if (problem.columnCount() == 0 || problem.target.size() != problem.rows)
        throw LogicError("terms were asked for where there are no candidates");
    Fit fit = grown(problem, largestError, most);
    if (fit.error <= largestError)
        fit = pruned(std::move(fit), largestError);

    SparseWeights result;
    std::vector<std::size_t> order(fit.set.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::size_t i) { return fit.set.columns()[i]; });
    for (const std::size_t i : order) {
        result.columns.push_back(fit.set.columns()[i]);
        result.weights.push_back(fit.set.weights()[i]);
    }
    result.largestError = fit.error;
    const double squares =
        std::inner_product(fit.rest.begin(), fit.rest.end(), fit.rest.begin(), 0.0);
    result.rmsError = std::sqrt(squares / static_cast<double>(problem.rows));
    return result;
}

} // namespace irsg
