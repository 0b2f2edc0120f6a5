#include "irsg/radiance/exchange/LightSolution.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/core/ParallelFor.h"
#include "irsg/core/StageReport.h"

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

/// How much comes through what numbers that go by sets of LightExchange::through stand for, of
/// which each set has so many.
float passes(const LightFactors& factors, std::size_t number, std::size_t ofSet) {
    const std::size_t set = number / ofSet;
    return set == 0 ? 1.0f : static_cast<float>(factors.passing()[set - 1]);
}

/// Of a list that belongs to someone else.
std::shared_ptr<const LightPairs> lent(const LightPairs& pairs) {
    return {std::shared_ptr<const LightPairs>(), &pairs};
}

} // namespace

WeightedPairs LightFactors::withPassed(std::shared_ptr<const LightPairs> LightBalance::*which,
                                       const LightPairs& base,
                                       std::vector<float> LightThroughGas::*emitting) const {
    WeightedPairs all(lent(base));
    for (std::size_t i = 0; i < passing_.size(); ++i)
        all.add(exchange_.through()[i].balance.*which, static_cast<float>(passing_[i]));
    if (throughGas_.empty())
        return all;
    std::vector<std::vector<LightPart>> parts(base.receivers());
    parallelForSmall(base.receivers(),
                     [&](std::uint32_t r) { addGas(r, which, emitting, parts[r]); });
    all.add(std::make_shared<const LightPairs>(base.receivers(), std::move(parts)), 1.0f);
    return all;
}

void LightFactors::addGas(std::uint32_t receiver,
                          std::shared_ptr<const LightPairs> LightBalance::*which,
                          std::vector<float> LightThroughGas::*emitting,
                          std::vector<LightPart>& parts) const {
    const auto senders = static_cast<std::uint32_t>(exchange_.senders());
    for (std::size_t i = 0; i < throughGas_.size(); ++i) {
        const LightThroughGas& gas = exchange_.throughGas()[i];
        const auto [first, last] = (gas.balance.*which)->of(receiver);
        for (const LightPair* pair = first; pair != last; ++pair)
            parts.push_back({receiver, pair->sender,
                             static_cast<float>(throughGas_[i].passing) * pair->factor});
        const float part = (gas.*emitting)[receiver];
        for (std::uint32_t z = 0; part > 0.0f && z < throughGas_[i].sent.size(); ++z)
            if (throughGas_[i].sent[z] > 0.0)
                parts.push_back(
                    {receiver, senders + z, part * static_cast<float>(throughGas_[i].sent[z])});
    }
}

LightFactors::LightFactors(const LightExchange& exchange, const LightKnot& knot)
    : exchange_(exchange), pairs_(lent(exchange.pairs())), between_(lent(exchange.between())) {
    if (exchange.through().empty() && exchange.throughGas().empty())
        return;
    for (const LightThrough& one : exchange.through()) {
        double& passes = passing_.emplace_back(1.0);
        for (const std::size_t pane : one.panes)
            passes *= knot.transmissivities[pane];
    }
    takeGas(knot);
    pairs_ = withPassed(&LightBalance::pairs, exchange.pairs(), &LightThroughGas::emitting);
    between_ =
        withPassed(&LightBalance::between, exchange.between(), &LightThroughGas::emittingToSenders);
}

double LightFactors::passedByGas(std::size_t sender, const LightColumn& column) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < throughGas_.size() && isBodyOf(sender, column); ++i) {
        const LightThroughGas& gas = exchange_.throughGas()[i];
        sum += throughGas_[i].passing * (column.pattern == LightPattern::passedSky ? gas.sky[sender]
                                         : column.pattern == LightPattern::passedGround
                                             ? gas.ground[sender]
                                             : 0.0);
    }
    return sum;
}

bool LightFactors::isBodyOf(std::size_t sender, const LightColumn& column) const {
    return column.isPassed() && exchange_.bodyOfSender(sender) == exchange_.bodyOfRow(column.row);
}

void LightFactors::takeGas(const LightKnot& knot) {
    const std::size_t senders = exchange_.gasSenders().size();
    for (const LightThroughGas& gas : exchange_.throughGas()) {
        ThroughGas& own = throughGas_.emplace_back();
        own.sent.assign(senders, 0.0);
        double panes = 1.0, columns = 1.0;
        for (const std::size_t pane : gas.panes)
            panes *= knot.transmissivities[pane];
        for (const std::size_t column : gas.columns) {
            for (std::size_t z = 0; z < senders; ++z)
                own.sent[z] += panes * columns *
                               knot.shares[(column - exchange_.firstGasPane()) * senders + z];
            columns *= knot.transmissivities[column];
        }
        own.passing = panes * (columns - 1.0);
    }
    if (throughGas_.empty() || exchange_.reflected().empty())
        return;
    std::vector<std::vector<LightPart>> parts(exchange_.senders());
    for (std::uint32_t s = 0; s < exchange_.senders(); ++s)
        addGas(s, &LightBalance::between, &LightThroughGas::emittingToSenders, parts[s]);
    const std::size_t senderCount = parts.size();
    changesByGas_ = std::make_shared<const LightPairs>(senderCount, std::move(parts));
}

double LightFactors::patternOf(std::size_t sender, LightPattern pattern) const {
    const auto sumOf = [&](double free, std::vector<double> LightThrough::*through) {
        for (std::size_t i = 0; i < passing_.size(); ++i)
            free += passing_[i] * (exchange_.through()[i].*through)[sender];
        return free;
    };
    const auto behindGas = [&](std::vector<double> LightThroughGas::*behind) {
        double sum = 0.0;
        for (std::size_t i = 0; i < throughGas_.size(); ++i)
            sum += throughGas_[i].passing * (exchange_.throughGas()[i].*behind)[sender];
        return sum;
    };
    switch (pattern) {
    case LightPattern::emission:
        return 1.0;
    case LightPattern::sun:
        return sumOf(exchange_.sun(sender), &LightThrough::sun);
    case LightPattern::sky:
        return sumOf(exchange_.sky(sender), &LightThrough::sky) + behindGas(&LightThroughGas::sky);
    case LightPattern::ground:
        return sumOf(exchange_.ground(sender), &LightThrough::ground) +
               behindGas(&LightThroughGas::ground);
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
    const auto add = [&](double passing, const OutsideLight& leaving) {
        sum += passing * (column.pattern == LightPattern::passedSky      ? leaving.sky
                          : column.pattern == LightPattern::passedGround ? leaving.ground
                                                                         : leaving.sun);
    };
    for (std::size_t i = 0; i < passing_.size(); ++i)
        add(passing_[i], exchange_.through()[i].leaving[receiver]);
    for (std::size_t i = 0; i < throughGas_.size(); ++i)
        add(throughGas_[i].passing, exchange_.throughGas()[i].leaving[receiver]);
    return sum;
}

double LightFactors::passedOn(std::size_t sender, const LightColumn& column) const {
    if (!isBodyOf(sender, column))
        return 0.0;
    return column.pattern == LightPattern::passedSky      ? patternOf(sender, LightPattern::sky)
           : column.pattern == LightPattern::passedGround ? patternOf(sender, LightPattern::ground)
                                                          : 0.0;
}

void LightSolution::number(const LightExchange& exchange, const std::vector<LightColumn>& columns) {
    places_.assign(exchange.receivers() + exchange.reflected().size(), none);
    for (std::size_t r = 0; r < exchange.receivers(); ++r)
        if (exchange.getsLight(r)) {
            places_[r] = receiver_.size();
            receiver_.push_back(r);
        }
    for (const std::uint32_t number : exchange.reflected())
        places_[number] = receiver_.size() + reflected_++;
    const auto isSent = [](const LightColumn& column) {
        return !column.isPassed() && column.component < 0;
    };
    sent_ = static_cast<std::size_t>(std::ranges::find_if_not(columns, isSent) - columns.begin());
    gathered_.resize(places() * columns_ * knots_);
    ofSenders_.resize(exchange.senders() * columns_ * knots_);
}

LightSolution::LightSolution(const LightExchange& exchange, const std::vector<LightColumn>& columns,
                             const std::vector<LightKnot>& knots, int bounces, double error)
    : columns_(columns.size()), knots_(knots.size()) {
    number(exchange, columns);
    const std::size_t senders = exchange.senders();
    std::vector<float> sent(exchange.sendersWithGas() * sent_);
    for (std::size_t c = 0; c < sent_; ++c)
        for (std::size_t gas = 0; gas < exchange.gasSenders().size(); ++gas)
            if (columns[c].row == exchange.gasSenders()[gas].row)
                sent[(senders + gas) * sent_ + c] = 1.0f;
    const std::vector<Columns> ofBodies =
        columnsOfBodies(exchange, std::span(columns).first(sent_));
    std::vector<std::size_t> passed;
    std::vector<std::vector<std::size_t>> ofRows(exchange.rows()); // columns that they send
    for (std::size_t c = 0; c < columns_; ++c) {
        if (columns[c].isPassed())
            passed.push_back(c);
        for (int row = 0; c < sent_ && row < static_cast<int>(exchange.rows()); ++row)
            if (columns[c].isOf(row))
                ofRows[static_cast<std::size_t>(row)].push_back(c);
    }
    // Each knot begins with what the last one ended with: reflectivities differ little.
    std::vector<float> leaving;
    StageCount count("bounces", knots_);
    for (std::size_t knot = 0; knot < knots_; ++knot, count.add()) {
        if (bounces > 0)
            leaving.clear();
        const LightFactors factors(exchange, knots[knot]);
        for (std::size_t s = 0; s < senders; ++s)
            for (const std::size_t c : ofRows[static_cast<std::size_t>(exchange.rowOfSender(s))])
                if (exchange.isSeen(s))
                    sent[s * sent_ + c] =
                        static_cast<float>(factors.patternOf(s, columns[c].pattern));
        iterate(factors, knots[knot].reflectivities, sent, sent_, ofBodies, bounces, error,
                leaving);
        const std::vector<float> all = arriving(factors, leaving, sent_, ofBodies);
        forEachInParts(receiver_.size(), [&](std::size_t p, std::size_t) {
            float* const own = &gathered_[(p * knots_ + knot) * columns_];
            std::copy_n(&all[p * sent_], sent_, own);
            if (factors.hasPassed())
                for (const std::size_t c : passed)
                    own[c] += static_cast<float>(factors.passedTo(receiver_[p], columns[c]));
            if (exchange.sunBesideMean().size() == 0)
                return;
            const auto [first, last] = exchange.sunBesideMean().of(receiver_[p]);
            for (const LightPair* pair = first; pair != last; ++pair)
                for (const std::size_t c : ofRows[pair->sender % exchange.rows()])
                    if (columns[c].pattern == LightPattern::sun)
                        own[c] += passes(factors, pair->sender, exchange.rows()) * pair->factor;
        });
        const std::vector<float> received = arrivingAtSenders(factors, leaving, sent_, ofBodies);
        for (std::size_t s = 0; s < senders; ++s)
            std::copy_n(&received[s * sent_], sent_, &ofSenders_[(s * knots_ + knot) * columns_]);
        if (reflected_ > 0)
            takeReflected(factors, columns, knot, leaving);
    }
}

void LightSolution::takeReflected(const LightFactors& factors,
                                  const std::vector<LightColumn>& columns, std::size_t knot,
                                  const std::vector<float>& leaving) {
    const LightExchange& exchange = factors.exchange();
    const std::size_t senders = exchange.senders(), rows = exchange.rows();
    const std::size_t bodies = exchange.bodies().size();
    std::vector<float> changes; // by sender
    if (const LightPairs* const gas = factors.changesByGas()) {
        changes.resize(senders * sent_);
        for (std::size_t s = 0; s < senders; ++s)
            gas->gather(s, leaving, sent_, sent_, &changes[s * sent_]);
    }
    const auto valueOf = [&](std::size_t i, std::size_t c) {
        const LightColumn& column = columns[c];
        if (i >= exchange.firstGasChanges()) {
            const std::size_t sender = i - exchange.firstGasChanges();
            return c < sent_ ? changes[sender * sent_ + c]
                             : static_cast<float>(factors.passedByGas(sender, column));
        }
        if (i < senders)
            return c < sent_ ? leaving[i * sent_ + c] : 0.0f;
        if (i < exchange.firstReceived())
            return column.pattern == LightPattern::sun &&
                           column.isOf(static_cast<int>((i - senders) % rows))
                       ? passes(factors, i - senders, rows)
                       : 0.0f;
        if (i < exchange.firstSunOnBodies()) {
            const std::size_t sender = i - exchange.firstReceived();
            return ofSenders_[(sender * knots_ + knot) * columns_ + c] +
                   static_cast<float>(factors.passedOn(sender, column));
        }
        if (i < exchange.firstComponents()) {
            const std::size_t number = i - exchange.firstSunOnBodies();
            return column.pattern == LightPattern::passedSun &&
                           exchange.bodyOfRow(column.row) == number % bodies
                       ? passes(factors, number, bodies)
                       : 0.0f;
        }
        return column.component == static_cast<int>(i - exchange.firstComponents()) ? 1.0f : 0.0f;
    };
    for (std::size_t i = 0; i < reflected_; ++i) {
        float* const own = &gathered_[((receiver_.size() + i) * knots_ + knot) * columns_];
        for (std::size_t c = 0; c < columns_; ++c)
            own[c] = valueOf(i, c);
    }
}

std::vector<float> LightSolution::arriving(const LightExchange& exchange, const LightKnot& knot,
                                           const std::vector<float>& sent, std::size_t width,
                                           int bounces, double error) const {
    const LightFactors factors(exchange, knot);
    std::vector<float> leaving;
    const std::vector<Columns> all(exchange.bodies().size(), {0, width});
    iterate(factors, knot.reflectivities, sent, width, all, bounces, error, leaving);
    return arriving(factors, leaving, width, all);
}

std::vector<LightSolution::Columns>
LightSolution::columnsOfBodies(const LightExchange& exchange, std::span<const LightColumn> sent) {
    std::vector<Columns> all(exchange.bodies().size(), {0, sent.size()});
    if (!exchange.areApart())
        return all;
    for (std::size_t b = 0; b < all.size(); ++b) {
        const auto isOfBody = [&](const LightColumn& column) {
            return exchange.bodyOfRow(column.row) == b;
        };
        const auto first = std::ranges::find_if(sent, isOfBody);
        auto last = sent.end();
        while (last != first && !isOfBody(*std::prev(last)))
            --last;
        all[b] = {static_cast<std::size_t>(first - sent.begin()),
                  static_cast<std::size_t>(last - first)};
    }
    return all;
}

std::vector<float> LightSolution::arriving(const LightFactors& factors,
                                           const std::vector<float>& leaving, std::size_t width,
                                           std::span<const Columns> ofBodies) const {
    std::vector<float> all(factors.exchange().receivers() * width);
    forEachInParts(receiver_.size(), [&](std::size_t p, std::size_t) {
        const std::size_t r = receiver_[p];
        const auto [first, count] = ofBodies[factors.exchange().bodyOf(r)];
        factors.pairs().gather(r, std::span(leaving).subspan(first), width, count,
                               &all[r * width + first]);
    });
    factors.exchange().sharpen(all, width);
    std::vector<float> arrives(places() * width);
    for (std::size_t p = 0; p < receiver_.size(); ++p)
        std::copy_n(&all[receiver_[p] * width], width, &arrives[p * width]);
    if (reflected_ == 0)
        return arrives;
    // What leaves a sender is what a lobe reflects of it, or its mirror reflects what it receives.
    const LightExchange& exchange = factors.exchange();
    std::copy_n(leaving.data(), exchange.senders() * width, &arrives[receiver_.size() * width]);
    if (exchange.areMirrorsFollowed())
        std::ranges::copy(arrivingAtSenders(factors, leaving, width, ofBodies),
                          &arrives[(receiver_.size() + exchange.firstReceived()) * width]);
    return arrives;
}

std::vector<float> LightSolution::arrivingAtSenders(const LightFactors& factors,
                                                    const std::vector<float>& leaving,
                                                    std::size_t width,
                                                    std::span<const Columns> ofBodies) {
    const LightExchange& exchange = factors.exchange();
    std::vector<float> all(exchange.senders() * width);
    forEachInParts(exchange.senders(), [&](std::size_t s, std::size_t) {
        const auto [first, count] = ofBodies[exchange.bodyOfSender(s)];
        factors.between().gather(s, std::span(leaving).subspan(first), width, count,
                                 &all[s * width + first]);
    });
    exchange.sharpenSent(all, width, ofBodies);
    return all;
}

void LightSolution::iterate(const LightFactors& factors, const std::vector<double>& reflectivities,
                            const std::vector<float>& sent, std::size_t width,
                            std::span<const Columns> ofBodies, int bounces, double error,
                            std::vector<float>& leaving) {
    // A change from the last knot's is that of a first iteration, too.
    const int fewest = leaving.empty() ? 3 : 2;
    if (leaving.empty())
        leaving = sent;
    const LightExchange& exchange = factors.exchange();
    std::vector<float> next = leaving, reflected(exchange.senders() * width);
    std::vector<std::size_t> reflecting;
    for (std::size_t s = 0; s < exchange.senders(); ++s)
        if (exchange.reflects(s) || (exchange.isSeen(s) && !factors.between().isEmpty(s)))
            reflecting.push_back(s);
    double before = 0.0;
    // What arrives after one bounce is what was sent: one step less.
    for (int n = 1; n <= mostIterations && n != bounces; ++n) {
        std::array<float, receiverParts> changes{}, largest{};
        forEachInParts(reflecting.size(), [&](std::size_t i, std::size_t) {
            const std::size_t s = reflecting[i];
            float* const own = &reflected[s * width];
            const auto [first, count] = ofBodies[exchange.bodyOfSender(s)];
            factors.between().gather(s, std::span(leaving).subspan(first), width, count,
                                     own + first);
            const auto rho = static_cast<float>(
                reflectivities[static_cast<std::size_t>(exchange.rowOfSender(s))]);
            for (std::size_t c = first; c < first + count; ++c)
                own[c] *= rho;
        });
        exchange.sharpenSent(reflected, width, ofBodies);
        forEachInParts(reflecting.size(), [&](std::size_t i, std::size_t part) {
            const std::size_t s = reflecting[i];
            const auto [first, count] = ofBodies[exchange.bodyOfSender(s)];
            for (std::size_t c = first; c < first + count; ++c) {
                const float now = sent[s * width + c] + reflected[s * width + c];
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
    return find(known_, {exchange, columns, knots, bounces, error});
}

std::shared_ptr<const LightSolution> LightSolutions::find(RecentlyUsed<Known>& known, Asked asked) {
    if (const Known* one = known.find([&](const Known& other) { return other.asked == asked; }))
        return one->solution;
    std::shared_ptr<const LightSolution> solution = solved(asked);
    return known.add({std::move(asked), std::move(solution)}).solution;
}

} // namespace irsg
