#include "irsg/atmosphere/ck/SparseWeights.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <tuple>
#include <utility>

#include "irsg/atmosphere/ck/ActiveSet.h"
#include "irsg/core/Errors.h"

namespace irsg {

namespace {

/// A set and how far it is from the target.
struct Fit {
    ActiveSet set;
    std::vector<double> rest;
    double error;

    explicit Fit(ActiveSet active)
        : set(std::move(active)), rest(set.residual()), error(largest(rest)) {}
};

/// Lawson's iteration towards the least largest error; the best of a few passes, of which there are
/// no more once the error is small enough.
Fit levelled(ActiveSet set, int passes, double enough = 0.0) {
    Fit best(std::move(set));
    Fit now = best;
    for (int pass = 0; pass < passes && best.error > enough; ++pass) {
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
    explicit Candidates(const SomeRows& problem)
        : problem_(problem), used_(problem.columnCount, 0) {
        for (std::size_t c = 0; c < problem.columnCount; ++c) {
            const double square = coarseProduct(problem.column(c), problem.column(c), problem.rows);
            perLength_.push_back(square > 0.0 ? 1.0 / std::sqrt(square) : 0.0);
        }
    }
    void refuse(std::size_t column) { refused_.push_back(column); }

    /// Unused columns whose directions lower the residual most, the steepest first, at most `most`:
    /// each the steepest among its neighbours, which say much the same, and no less than half as
    /// steep as the first.
    std::vector<std::size_t> steepest(const Fit& fit, std::size_t most) {
        constexpr std::size_t alike = 6;
        std::ranges::fill(used_, 0);
        for (const std::size_t c : fit.set.columns())
            used_[c] = 1;
        for (const std::size_t c : refused_)
            used_[c] = 1;
        std::vector<float> direction(problem_.rows);
        for (std::size_t r = 0; r < direction.size(); ++r)
            direction[r] = static_cast<float>(fit.rest[r]) * fit.set.importance()[r];
        std::vector<double> slopes(used_.size(), 0.0);
        for (std::size_t c = 0; c < used_.size(); ++c)
            if (!used_[c])
                slopes[c] = coarseProduct(problem_.column(c), direction.data(), problem_.rows) *
                            perLength_[c];
        std::vector<std::size_t> found;
        double first = 0.0;
        while (found.size() < most) {
            const auto best = std::ranges::max_element(slopes);
            if (best == slopes.end() || *best <= 0.5 * first)
                break;
            if (found.empty())
                first = *best;
            const auto at = static_cast<std::size_t>(best - slopes.begin());
            found.push_back(at);
            for (std::size_t c = at > alike ? at - alike : 0; c <= at + alike && c < slopes.size();
                 ++c)
                slopes[c] = 0.0;
        }
        return found;
    }

  private:
    const SomeRows& problem_;
    std::vector<double> perLength_;
    std::vector<char> used_;
    std::vector<std::size_t> refused_; ///< they say nothing new
};

/// Adds columns to a set, the more at once the larger it is, until no row's error is above
/// `largestError`, `most` are in use or none helps.
Fit grown(const SomeRows& problem, ActiveSet start, double largestError, std::size_t most) {
    // A fit that is stuck comes loose as a rule: some sets need a hundred columns more for it.
    constexpr int patience = 60;
    constexpr std::size_t perNew = 8, perLevelled = 3;
    Candidates candidates(problem);
    Fit fit(std::move(start));
    if (fit.set.size() > 0)
        fit = levelled(std::move(fit.set), fit.set.size() < most ? 1 : 6, largestError);
    Fit best = fit;
    int fruitless = 0;
    bool isAlone = false; // one at a time, where none of many stayed
    std::size_t levelledAt = fit.set.size();
    while (best.error > largestError && fit.set.size() < most && fruitless < patience) {
        const std::size_t room = most - fit.set.size();
        const std::vector<std::size_t> next =
            candidates.steepest(fit, isAlone ? 1 : std::min(1 + fit.set.size() / perNew, room));
        ActiveSet with = std::move(fit.set);
        if (next.empty()) // the least squares of these rows as they count now
            with.emphasize(fit.rest);
        else
            with.add(next);
        while (!with.solve()) {
            candidates.refuse(with.columns()[with.dependent()]);
            with.remove(with.dependent());
        }
        const bool wasAlone = isAlone;
        isAlone = std::ranges::find_first_of(with.columns(), next) == with.columns().end();
        if (isAlone && wasAlone && !next.empty())
            candidates.refuse(next.front());
        fit = Fit(std::move(with));
        if (fit.set.size() >= levelledAt + 1 + levelledAt / perLevelled) {
            levelledAt = fit.set.size();
            fit = levelled(std::move(fit.set), 1);
        }
        fruitless = fit.error < best.error ? 0 : fruitless + 1;
        if (fit.error < best.error)
            best = fit;
    }
    return best;
}

/// How far a set is from the target in every row of a problem.
std::vector<double> restOf(const SparseProblem& problem, const ActiveSet& set) {
    std::vector<double> rest = problem.target;
    for (std::size_t r = 0; r < rest.size(); ++r)
        for (std::size_t i = 0; i < set.size(); ++i)
            rest[r] -= set.weights()[i] * static_cast<double>(problem.row(r)[set.columns()[i]]);
    return rest;
}

/// The columns of a set in every row of a problem, side by side: a few of thousands.
class ColumnsOf {
  public:
    ColumnsOf(const SparseProblem& problem, const ActiveSet& set)
        : target_(problem.target), columns_(set.columns()) {
        values_.reserve(problem.rows() * columns_.size());
        for (std::size_t r = 0; r < problem.rows(); ++r)
            for (const std::size_t column : columns_)
                values_.push_back(problem.row(r)[column]);
    }
    /// How far some of these columns are from the target in the row where they are farthest.
    double largestRest(const ActiveSet& some) const {
        std::vector<double> weights(columns_.size(), 0.0);
        for (std::size_t i = 0; i < some.size(); ++i)
            weights[static_cast<std::size_t>(std::ranges::find(columns_, some.columns()[i]) -
                                             columns_.begin())] = some.weights()[i];
        double most = 0.0;
        for (std::size_t r = 0; r < target_.size(); ++r)
            most = std::max(most, std::abs(target_[r] - product(weights.data(),
                                                                values_.data() + r * weights.size(),
                                                                weights.size())));
        return most;
    }

  private:
    const std::vector<double>& target_;
    std::vector<std::size_t> columns_;
    std::vector<float> values_; ///< row by row
};

/// Takes out what matters least, a sixteenth at once, as long as the error stays within the bound
/// in every row of the problem. One by one would leave a tenth less for twice the time.
Fit pruned(const SparseProblem& problem, Fit fit, double largestError) {
    constexpr int passes = 3;
    constexpr std::size_t part = 16;
    const ColumnsOf columns(problem, fit.set);
    for (;;) {
        std::vector<std::size_t> places = fit.set.dispensable();
        places.resize(std::min(places.size(), std::max<std::size_t>(1, fit.set.size() / part)));
        if (places.size() >= fit.set.size())
            return fit;
        std::ranges::sort(places, std::ranges::greater());
        ActiveSet fewer = fit.set;
        for (const std::size_t place : places)
            fewer.remove(place);
        if (!fewer.solve())
            return fit;
        Fit trial = levelled(std::move(fewer), passes, largestError);
        if (trial.error > largestError || columns.largestRest(trial.set) > largestError)
            return fit;
        fit = std::move(trial);
    }
}

/// Rows that a fit sees: some of a problem, and what it misses.
class WorkingRows {
  public:
    WorkingRows(std::size_t all, std::size_t few) : isIn_(all, 0) {
        const std::size_t step = std::max<std::size_t>(1, all / few);
        for (std::size_t r = 0; r < all; r += step)
            take(r);
    }
    const std::vector<std::size_t>& rows() const { return rows_; }

    /// Takes in the rows of the largest errors above a bound; false where there is none.
    bool grow(const std::vector<double>& rest, double bound, std::size_t most) {
        std::vector<std::size_t> missed;
        for (std::size_t r = 0; r < rest.size(); ++r)
            if (!isIn_[r] && std::abs(rest[r]) > bound)
                missed.push_back(r);
        std::ranges::stable_sort(missed, std::ranges::greater(),
                                 [&](std::size_t r) { return std::abs(rest[r]); });
        missed.resize(std::min(missed.size(), most));
        for (const std::size_t r : missed)
            take(r);
        return !missed.empty();
    }

  private:
    void take(std::size_t r) {
        rows_.push_back(r);
        isIn_[r] = 1;
    }
    std::vector<std::size_t> rows_;
    std::vector<char> isIn_;
};

} // namespace

SparseWeights sparseWeights(const SparseProblem& problem, double largestError, std::size_t most) {
    if (problem.columnCount == 0 || problem.matrix.size() != problem.columnCount * problem.rows())
        throw LogicError("quadrature points were asked for where there are no candidates");
    constexpr std::size_t fewRows = 110, moreRows = 150;
    // Few rows say little of the last columns: the first rounds stop early.
    constexpr double firstBound = 15.0, nextBound = 0.4;
    constexpr int rounds = 12;
    // Rows that are not looked at may be a little worse than those that are.
    const double bound = 0.9 * largestError;

    WorkingRows working(problem.rows(), fewRows);
    auto some = std::make_unique<SomeRows>(problem, working.rows());
    SparseWeights result;
    result.largestError = HUGE_VAL;
    const auto take = [&](const Fit& fit, const std::vector<double>& rest) {
        result.columns = fit.set.columns();
        result.weights = fit.set.weights();
        result.largestError = largest(rest);
        result.rmsError =
            std::sqrt(std::inner_product(rest.begin(), rest.end(), rest.begin(), 0.0) /
                      static_cast<double>(rest.size()));
    };
    ActiveSet start(*some);
    for (int round = 0; round < rounds; ++round) {
        const double now = bound * std::max(1.0, firstBound * std::pow(nextBound, round));
        Fit fit = grown(*some, std::move(start), now, most);
        const std::vector<double> rest = restOf(problem, fit.set);
        if (largest(rest) < result.largestError)
            take(fit, rest);
        if (result.largestError <= largestError) {
            fit = pruned(problem, std::move(fit), largestError);
            take(fit, restOf(problem, fit.set));
            break;
        }
        if (!working.grow(rest, std::max(bound, fit.error), moreRows) && now <= bound)
            break;
        auto more = std::make_unique<SomeRows>(problem, working.rows());
        start = ActiveSet(*more, fit.set);
        some = std::move(more);
    }
    std::vector<std::pair<std::size_t, double>> weighted;
    for (std::size_t i = 0; i < result.columns.size(); ++i)
        weighted.emplace_back(result.columns[i], result.weights[i]);
    std::ranges::sort(weighted);
    for (std::size_t i = 0; i < weighted.size(); ++i)
        std::tie(result.columns[i], result.weights[i]) = weighted[i];
    return result;
}

} // namespace irsg
