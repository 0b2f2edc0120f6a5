#include "irsg/radiance/exchange/LightSolution.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/core/ParallelFor.h"

namespace irsg {

namespace {

/// Pieces that receivers are divided into, whatever the number of cores.
constexpr std::size_t receiverParts = 16;
constexpr int mostIterations = 20'000;

double patternOf(const LightExchange& exchange, std::size_t receiver, LightPattern pattern) {
    switch (pattern) {
    case LightPattern::emission:
        return 1.0;
    case LightPattern::sun:
        return exchange.sun(receiver);
    case LightPattern::sky:
        return exchange.sky(receiver);
    case LightPattern::ground:
        return exchange.ground(receiver);
    }
    return 0.0;
}

} // namespace

LightSolution::LightSolution(const LightExchange& exchange, const std::vector<LightColumn>& columns,
                             const std::vector<std::vector<double>>& knots, int bounces,
                             double error)
    : columns_(columns.size()), knots_(knots.size()), places_(exchange.receivers(), none) {
    const std::size_t receivers = exchange.receivers();
    for (std::size_t r = 0; r < receivers; ++r)
        if (!exchange.pairs().isEmpty(r)) {
            places_[r] = receiver_.size();
            receiver_.push_back(r);
        }
    gathered_.resize(receiver_.size() * columns_ * knots_);
    std::vector<float> sent(receivers * columns_);
    for (std::size_t r = 0; r < receivers; ++r)
        for (std::size_t c = 0; c < columns_; ++c)
            if (exchange.isSender(r) && columns[c].row == exchange.rowOf(r))
                sent[r * columns_ + c] =
                    static_cast<float>(patternOf(exchange, r, columns[c].pattern));
    // Each knot begins with what the last one ended with: reflectivities differ little.
    std::vector<float> leaving;
    for (std::size_t knot = 0; knot < knots_; ++knot) {
        if (bounces > 0)
            leaving.clear();
        const std::vector<float> all =
            arriving(exchange, knots[knot], sent, columns_, bounces, error, leaving);
        for (std::size_t p = 0; p < receiver_.size(); ++p)
            std::copy_n(&all[p * columns_], columns_, &gathered_[(p * knots_ + knot) * columns_]);
    }
}

std::vector<float> LightSolution::arriving(const LightExchange& exchange,
                                           const std::vector<double>& reflectivities,
                                           const std::vector<float>& sent, std::size_t width,
                                           int bounces, double error) const {
    std::vector<float> leaving;
    return arriving(exchange, reflectivities, sent, width, bounces, error, leaving);
}

std::vector<float> LightSolution::arriving(const LightExchange& exchange,
                                           const std::vector<double>& reflectivities,
                                           const std::vector<float>& sent, std::size_t width,
                                           int bounces, double error,
                                           std::vector<float>& leaving) const {
    // A change from the last knot's is that of a first iteration, too.
    const int fewest = leaving.empty() ? 3 : 2;
    if (leaving.empty())
        leaving = sent;
    std::vector<float> next = leaving, arrives(receiver_.size() * width);
    double before = 0.0;
    for (int n = 1; n <= mostIterations; ++n) {
        std::array<float, receiverParts> changes{}, largest{};
        parallelFor(receiverParts, [&](std::size_t part) {
            float change = 0.0f, most = 0.0f;
            for (std::size_t p = beginOfPart(part, receiverParts, receiver_.size());
                 p < beginOfPart(part + 1, receiverParts, receiver_.size()); ++p) {
                const std::size_t r = receiver_[p];
                float* own = &arrives[p * width];
                exchange.pairs().gather(r, leaving, width, own);
                if (!exchange.isSender(r))
                    continue;
                const auto rho =
                    static_cast<float>(reflectivities[static_cast<std::size_t>(exchange.rowOf(r))]);
                for (std::size_t c = 0; c < width; ++c) {
                    const float now = sent[r * width + c] + rho * own[c];
                    change = std::max(change, std::abs(now - leaving[r * width + c]));
                    most = std::max(most, now);
                    next[r * width + c] = now;
                }
            }
            changes[part] = change;
            largest[part] = most;
        });
        if (n == bounces)
            break;
        std::swap(leaving, next);
        const auto change = static_cast<double>(*std::ranges::max_element(changes));
        const double scale = std::max(static_cast<double>(*std::ranges::max_element(largest)), 1.0);
        // What is still to come, if it goes on as from the last change to this.
        const double ratio = before > 0.0 ? std::min(change / before, 0.999) : 0.0;
        if (change == 0.0 || (n >= fewest && change * ratio <= error * scale * (1.0 - ratio)))
            break;
        before = change;
    }
    return arrives;
}

std::shared_ptr<const LightSolution>
LightSolutions::of(const std::shared_ptr<const LightExchange>& exchange,
                   const std::vector<LightColumn>& columns,
                   const std::vector<std::vector<double>>& knots, int bounces, double error) {
    return known_
        .of(
            [&](const Known& one) {
                return one.exchange == exchange && one.columns == columns && one.knots == knots &&
                       one.bounces == bounces && one.error == error;
            },
            [&] {
                return Known{
                    exchange,
                    columns,
                    knots,
                    bounces,
                    error,
                    std::make_shared<const LightSolution>(*exchange, columns, knots, bounces, error)};
            })
        .solution;
}

} // namespace irsg
