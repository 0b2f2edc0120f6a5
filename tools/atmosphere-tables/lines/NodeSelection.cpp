#include "tools/atmosphere-tables/lines/NodeSelection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "irsg/core/Errors.h"

namespace irsg::lbl {

namespace {

/// The least-squares problem in normal form: error(w) = w'Gw - 2 c'w + b.
struct NormalForm {
    std::size_t count = 0;
    std::vector<double> gram; ///< count x count
    std::vector<double> right;
    double constant = 0.0;
    double weightSum = 0.0; ///< of the rows without the one that holds the sum at 1

    double g(std::size_t i, std::size_t j) const { return gram[i * count + j]; }
};

NormalForm normalForm(const TrainingMatrix& training) {
    NormalForm form;
    form.count = training.columnCount();
    form.gram.resize(form.count * form.count);
    form.right.resize(form.count);

    // Weighted columns first, so that the products below are plain sums.
    std::vector<float> weighted(training.columns.size());
    for (std::size_t i = 0; i < form.count; ++i)
        for (std::size_t r = 0; r < training.rows; ++r)
            weighted[i * training.rows + r] =
                static_cast<float>(training.rowWeights[r] *
                                   (static_cast<double>(training.columns[i * training.rows + r]) -
                                    training.target[r]));
    for (const double weight : training.rowWeights)
        form.weightSum += weight * weight;

    // With weights that sum to 1 the residual is the weighted sum of (column - target); the sum is
    // held by a penalty that outweighs every row.
    const double penalty = 100.0 * form.weightSum;
    for (std::size_t i = 0; i < form.count; ++i) {
        const float* a = weighted.data() + i * training.rows;
        for (std::size_t j = i; j < form.count; ++j) {
            const float* b = weighted.data() + j * training.rows;
            double sum = 0.0;
            for (std::size_t r = 0; r < training.rows; ++r)
                sum += static_cast<double>(a[r] * b[r]);
            form.gram[i * form.count + j] = form.gram[j * form.count + i] = sum + penalty;
        }
        form.right[i] = penalty;
    }
    form.constant = penalty;
    return form;
}

struct Fit {
    std::vector<std::size_t> columns;
    std::vector<double> weights;
    double error = std::numeric_limits<double>::infinity();
};

/// Solves the system of a few columns by Cholesky's decomposition; false where it is singular.
bool solve(const NormalForm& form, const std::vector<std::size_t>& columns,
           std::vector<double>& weights) {
    const std::size_t n = columns.size();
    constexpr std::size_t most = 128;
    thread_local std::vector<double> factor(most * most);
    if (n > most)
        throw LogicError("too many nodes were asked for");
    weights.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = form.g(columns[i], columns[j]);
            for (std::size_t k = 0; k < j; ++k)
                sum -= factor[i * most + k] * factor[j * most + k];
            if (i == j) {
                if (sum <= 1e-12 * form.g(columns[i], columns[i]))
                    return false;
                factor[i * most + i] = std::sqrt(sum);
            } else {
                factor[i * most + j] = sum / factor[j * most + j];
            }
        }
        double sum = form.right[columns[i]];
        for (std::size_t k = 0; k < i; ++k)
            sum -= factor[i * most + k] * weights[k];
        weights[i] = sum / factor[i * most + i];
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k)
            weights[i] -= factor[k * most + i] * weights[k];
        weights[i] /= factor[i * most + i];
    }
    return true;
}

/// Non-negative least squares over a few columns: those that come out negative are left out.
Fit fitted(const NormalForm& form, std::vector<std::size_t> columns) {
    Fit fit;
    std::vector<double> weights;
    while (!columns.empty() && solve(form, columns, weights)) {
        const auto lowest = std::ranges::min_element(weights);
        if (*lowest > 0.0) {
            fit.error = form.constant;
            for (std::size_t i = 0; i < columns.size(); ++i)
                fit.error -= weights[i] * form.right[columns[i]];
            fit.columns = std::move(columns);
            fit.weights = std::move(weights);
            break;
        }
        columns.erase(columns.begin() + (lowest - weights.begin()));
    }
    return fit;
}

bool improves(const Fit& fit, const Fit& best) {
    return fit.error < best.error * (1.0 - 1e-9) - 1e-300;
}

/// The best fit with one more column.
Fit extended(const NormalForm& form, const Fit& fit) {
    Fit best = fit;
    std::vector<std::size_t> trial = fit.columns;
    trial.push_back(0);
    for (std::size_t i = 0; i < form.count; ++i) {
        if (std::ranges::find(fit.columns, i) != fit.columns.end())
            continue;
        trial.back() = i;
        if (Fit next = fitted(form, trial); improves(next, best))
            best = std::move(next);
    }
    return best;
}

/// Exchanges single columns as long as that lowers the error, twice around at most.
Fit exchanged(const NormalForm& form, Fit fit) {
    for (int round = 0; round < 2; ++round) {
        bool better = false;
        for (std::size_t place = 0; place < fit.columns.size(); ++place) {
            Fit best = fit;
            for (std::size_t i = 0; i < form.count; ++i) {
                if (std::ranges::find(fit.columns, i) != fit.columns.end())
                    continue;
                std::vector<std::size_t> trial = fit.columns;
                trial[place] = i;
                if (Fit next = fitted(form, std::move(trial)); improves(next, best)) {
                    best = std::move(next);
                    better = true;
                }
            }
            fit = std::move(best);
        }
        if (!better)
            break;
    }
    return fit;
}

/// Weighted sum less target, row by row.
std::vector<double> errorsOf(const TrainingMatrix& training, const Fit& fit) {
    std::vector<double> errors(training.rows);
    const double sum = std::accumulate(fit.weights.begin(), fit.weights.end(), 0.0);
    for (std::size_t r = 0; r < training.rows; ++r)
        errors[r] = -training.target[r];
    for (std::size_t i = 0; i < fit.columns.size(); ++i) {
        const auto column = training.column(fit.columns[i]);
        for (std::size_t r = 0; r < training.rows; ++r)
            errors[r] += fit.weights[i] / sum * static_cast<double>(column[r]);
    }
    return errors;
}

double largestError(const TrainingMatrix& training, const Fit& fit) {
    double largest = 0.0;
    for (const double error : errorsOf(training, fit))
        largest = std::max(largest, std::abs(error));
    return largest;
}

} // namespace

NodeSelection selectNodes(const TrainingMatrix& training, const NodeGoals& goals) {
    const NormalForm form = normalForm(training);
    if (form.count == 0 || goals.most == 0)
        throw LogicError("nodes were asked for where there are no candidates");
    const double wanted = goals.rms * goals.rms * form.weightSum;

    Fit fit = extended(form, Fit{});
    while (fit.columns.size() < goals.most &&
           (fit.error > wanted || largestError(training, fit) > goals.largest)) {
        const Fit more = exchanged(form, extended(form, fit));
        if (!improves(more, fit))
            break;
        fit = more;
    }

    NodeSelection chosen;
    std::vector<std::size_t> order(fit.columns.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::size_t i) { return fit.columns[i]; });
    const double sum = std::accumulate(fit.weights.begin(), fit.weights.end(), 0.0);
    for (const std::size_t i : order) {
        chosen.columns.push_back(fit.columns[i]);
        chosen.weights.push_back(fit.weights[i] / sum);
    }
    const std::vector<double> errors = errorsOf(training, fit);
    double squares = 0.0;
    for (const double error : errors) {
        squares += error * error;
        chosen.largestError = std::max(chosen.largestError, std::abs(error));
    }
    chosen.rmsError = std::sqrt(squares / static_cast<double>(training.rows));
    return chosen;
}

} // namespace irsg::lbl
