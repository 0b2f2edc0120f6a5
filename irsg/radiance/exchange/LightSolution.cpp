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

/// Calls work(i, part) for numbers i below a count, on all cores; a part is one at a time.
template <typename Work>
void forEachInParts(std::size_t count, Work work) {
    parallelFor(receiverParts, [&](std::size_t part) {
        for (std::size_t i = beginOfPart(part, receiverParts, count);
             i < beginOfPart(part + 1, receiverParts, count); ++i)
            work(i, part);
    });
}

/// What is sent through nothing and through transparent surfaces.
std::shared_ptr<const LightPairs> summed(const LightExchange& exchange,
                                         std::span<const double> passing,
                                         std::shared_ptr<const LightPairs> LightBalance::*which,
                                         const LightPairs& base) {
    std::vector<std::vector<LightPart>> parts(base.receivers());
    parallelForSmall(base.receivers(), [&](std::uint32_t r) {
        const auto add = [&](const LightPairs& pairs, float by) {
            const auto [first, last] = pairs.of(r);
            for (const LightPair* pair = first; pair != last && by > 0.0f; ++pair)
                parts[r].push_back({r, pair->sender, by * pair->factor});
        };
        add(base, 1.0f);
        for (std::size_t i = 0; i < passing.size(); ++i)
            add(*(exchange.through()[i].balance.*which), static_cast<float>(passing[i]));
    });
    return std::make_shared<const LightPairs>(base.receivers(), std::move(parts));
}

/// Of a list that belongs to someone else.
std::shared_ptr<const LightPairs> lent(const LightPairs& pairs) {
    return {std::shared_ptr<const LightPairs>(), &pairs};
}

} // namespace

LightFactors::LightFactors(const LightExchange& exchange, std::span<const double> transmissivities)
    : exchange_(exchange), pairs_(lent(exchange.pairs())), between_(lent(exchange.between())) {
    if (exchange.through().empty())
        return;
    for (const LightThrough& one : exchange.through()) {
        double& passes = passing_.emplace_back(1.0);
        for (const std::size_t pane : one.panes)
            passes *= transmissivities[pane];
    }
    const bool isOne = pairs_ == between_;
    pairs_ = summed(exchange, passing_, &LightBalance::pairs, exchange.pairs());
    between_ =
        isOne ? pairs_ : summed(exchange, passing_, &LightBalance::between, exchange.between());
}

double LightFactors::patternOf(std::size_t sender, LightPattern pattern) const {
    const auto sumOf = [&](double free, std::vector<double> LightThrough::*through) {
        for (std::size_t i = 0; i < passing_.size(); ++i)
            free += passing_[i] * (exchange_.through()[i].*through)[sender];
        return free;
    };
    switch (pattern) {
    case LightPattern::emission:
        return 1.0;
    case LightPattern::sun:
        return sumOf(exchange_.sun(sender), &LightThrough::sun);
    case LightPattern::sky:
        return sumOf(exchange_.sky(sender), &LightThrough::sky);
    case LightPattern::ground:
        return sumOf(exchange_.ground(sender), &LightThrough::ground);
    case LightPattern::passedSky:
    case LightPattern::passedGround:
    case LightPattern::passedSun:
        return 0.0; // sent by no surface
    }
    return 0.0;
}

double LightFactors::passedTo(std::size_t receiver, const LightColumn& column) const {
    double sum = 0.0;
    if (!column.isPassed() || exchange_.bodyOf(receiver) != exchange_.bodyOfRow(column.row))
        return sum;
    for (std::size_t i = 0; i < passing_.size(); ++i) {
        const OutsideLight& leaving = exchange_.through()[i].leaving[receiver];
        sum += passing_[i] * (column.pattern == LightPattern::passedSky      ? leaving.sky
                              : column.pattern == LightPattern::passedGround ? leaving.ground
                                                                             : leaving.sun);
    }
    return sum;
}

LightSolution::LightSolution(const LightExchange& exchange, const std::vector<LightColumn>& columns,
                             const std::vector<LightKnot>& knots, int bounces, double error)
    : columns_(columns.size()),
      knots_(knots.size()),
      places_(exchange.receivers() + exchange.reflected().size(), none) {
    for (std::size_t r = 0; r < exchange.receivers(); ++r)
        if (exchange.getsLight(r)) {
            places_[r] = receiver_.size();
            receiver_.push_back(r);
        }
    for (const std::uint32_t number : exchange.reflected())
        places_[number] = receiver_.size() + reflected_++;
    const std::size_t senders = exchange.senders();
    gathered_.resize(places() * columns_ * knots_);
    ofSenders_.resize(senders * columns_ * knots_);
    std::vector<float> sent(senders * columns_);
    // Each knot begins with what the last one ended with: reflectivities differ little.
    std::vector<float> leaving;
    for (std::size_t knot = 0; knot < knots_; ++knot) {
        if (bounces > 0)
            leaving.clear();
        const LightFactors factors(exchange, knots[knot].transmissivities);
        for (std::size_t s = 0; s < senders; ++s)
            for (std::size_t c = 0; c < columns_; ++c)
                if (exchange.isSeen(s) && columns[c].row == exchange.rowOfSender(s))
                    sent[s * columns_ + c] =
                        static_cast<float>(factors.patternOf(s, columns[c].pattern));
        iterate(factors, knots[knot].reflectivities, sent, columns_, bounces, error, leaving);
        const std::vector<float> all = arriving(factors, leaving, columns_);
        const auto rows = static_cast<int>(exchange.rows());
        const auto passes = [&](std::size_t number) { // of the sun beside means
            const std::size_t set = number / static_cast<std::size_t>(rows);
            return set == 0 ? 1.0f : static_cast<float>(factors.passing()[set - 1]);
        };
        for (std::size_t p = 0; p < receiver_.size(); ++p) {
            float* const own = &gathered_[(p * knots_ + knot) * columns_];
            std::copy_n(&all[p * columns_], columns_, own);
            for (std::size_t c = 0; c < columns_ && !factors.passing().empty(); ++c)
                own[c] += static_cast<float>(factors.passedTo(receiver_[p], columns[c]));
            if (exchange.sunBesideMean().size() == 0)
                continue;
            const auto [first, last] = exchange.sunBesideMean().of(receiver_[p]);
            for (const LightPair* pair = first; pair != last; ++pair)
                for (std::size_t c = 0; c < columns_; ++c)
                    if (columns[c].pattern == LightPattern::sun &&
                        columns[c].row == static_cast<int>(pair->sender) % rows)
                        own[c] += passes(pair->sender) * pair->factor;
        }
        for (std::size_t i = 0; i < reflected_; ++i) {
            float* const own = &gathered_[((receiver_.size() + i) * knots_ + knot) * columns_];
            for (std::size_t c = 0; c < columns_; ++c)
                own[c] = i < senders ? leaving[i * columns_ + c]
                         : columns[c].pattern == LightPattern::sun &&
                                 columns[c].row == static_cast<int>(i - senders) % rows
                             ? passes(i - senders)
                             : 0.0f;
        }
        forEachInParts(senders, [&](std::size_t s, std::size_t) {
            factors.between().gather(s, leaving, columns_,
                                     &ofSenders_[(s * knots_ + knot) * columns_]);
        });
    }
}

std::vector<float> LightSolution::arriving(const LightExchange& exchange, const LightKnot& knot,
                                           const std::vector<float>& sent, std::size_t width,
                                           int bounces, double error) const {
    const LightFactors factors(exchange, knot.transmissivities);
    std::vector<float> leaving;
    iterate(factors, knot.reflectivities, sent, width, bounces, error, leaving);
    return arriving(factors, leaving, width);
}

std::vector<float> LightSolution::arriving(const LightFactors& factors,
                                           const std::vector<float>& leaving,
                                           std::size_t width) const {
    std::vector<float> all(factors.exchange().receivers() * width);
    forEachInParts(receiver_.size(), [&](std::size_t p, std::size_t) {
        factors.pairs().gather(receiver_[p], leaving, width, &all[receiver_[p] * width]);
    });
    factors.exchange().sharpen(all, width);
    std::vector<float> arrives(places() * width);
    for (std::size_t p = 0; p < receiver_.size(); ++p)
        std::copy_n(&all[receiver_[p] * width], width, &arrives[p * width]);
    if (reflected_ > 0) // what leaves a sender is what a lobe reflects of it
        std::ranges::copy(leaving, &arrives[receiver_.size() * width]);
    return arrives;
}

void LightSolution::iterate(const LightFactors& factors, const std::vector<double>& reflectivities,
                            const std::vector<float>& sent, std::size_t width, int bounces,
                            double error, std::vector<float>& leaving) {
    // A change from the last knot's is that of a first iteration, too.
    const int fewest = leaving.empty() ? 3 : 2;
    if (leaving.empty())
        leaving = sent;
    std::vector<float> next = leaving;
    const LightExchange& exchange = factors.exchange();
    std::vector<std::size_t> reflecting;
    for (std::size_t s = 0; s < exchange.senders(); ++s)
        if (exchange.isSeen(s) && !factors.between().isEmpty(s))
            reflecting.push_back(s);
    std::vector<std::vector<float>> rooms(receiverParts, std::vector<float>(width));
    double before = 0.0;
    // What arrives after one bounce is what was sent: one step less.
    for (int n = 1; n <= mostIterations && n != bounces; ++n) {
        std::array<float, receiverParts> changes{}, largest{};
        forEachInParts(reflecting.size(), [&](std::size_t i, std::size_t part) {
            const std::size_t s = reflecting[i];
            float* own = rooms[part].data();
            factors.between().gather(s, leaving, width, own);
            const auto rho = static_cast<float>(
                reflectivities[static_cast<std::size_t>(exchange.rowOfSender(s))]);
            for (std::size_t c = 0; c < width; ++c) {
                const float now = sent[s * width + c] + rho * own[c];
                changes[part] = std::max(changes[part], std::abs(now - leaving[s * width + c]));
                largest[part] = std::max(largest[part], now);
                next[s * width + c] = now;
            }
        });
        std::swap(leaving, next);
        const auto change = static_cast<double>(*std::ranges::max_element(changes));
        const double scale = std::max(static_cast<double>(*std::ranges::max_element(largest)), 1.0);
        // What is still to come, if it goes on as from the last change to this.
        const double ratio = before > 0.0 ? std::min(change / before, 0.999) : 0.0;
        if (change == 0.0 || (n >= fewest && change * ratio <= error * scale * (1.0 - ratio)))
            break;
        before = change;
    }
}

std::shared_ptr<const LightSolution>
LightSolutions::of(const std::shared_ptr<const LightExchange>& exchange,
                   const std::vector<LightColumn>& columns, const std::vector<LightKnot>& knots,
                   int bounces, double error) {
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
