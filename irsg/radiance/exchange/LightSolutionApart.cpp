// Solutions of bodies that neither light, shade nor hide each other: each as it is alone.
#include <algorithm>

#include "irsg/core/ParallelFor.h"
#include "irsg/radiance/exchange/LightSolution.h"

namespace irsg {

namespace {

/// The columns of a body's rows among all, by their numbers.
std::vector<std::size_t> columnsOf(const LightExchange& exchange, std::size_t body,
                                   const std::vector<LightColumn>& columns) {
    std::vector<std::size_t> own;
    for (std::size_t c = 0; c < columns.size(); ++c)
        if (exchange.bodyOfRow(columns[c].row) == body)
            own.push_back(c);
    return own;
}

/// A knot with the transmissivities that the exchange of a body alone has.
LightKnot knotOf(const LightExchange& all, const LightExchange& own, const LightKnot& knot) {
    LightKnot alone{knot.reflectivities, {}, {}};
    for (const OccluderMaterial& pane : own.panes()) {
        const auto number = std::ranges::find(all.panes(), pane) - all.panes().begin();
        alone.transmissivities.push_back(knot.transmissivities[static_cast<std::size_t>(number)]);
    }
    return alone;
}

} // namespace

std::shared_ptr<const LightSolution> LightSolutions::solved(const Asked& asked) {
    const LightExchange& exchange = *asked.exchange;
    if (exchange.alone().empty())
        return std::make_shared<const LightSolution>(exchange, asked.columns, asked.knots,
                                                     asked.bounces, asked.error);
    std::vector<LightSolution::OfBody> ofBodies;
    for (std::size_t b = 0; b < exchange.alone().size(); ++b) {
        const std::shared_ptr<const LightExchange>& own = exchange.alone()[b];
        std::vector<std::size_t> numbers = columnsOf(exchange, b, asked.columns);
        Asked alone{own, {}, {}, asked.bounces, asked.error};
        for (const std::size_t c : numbers)
            alone.columns.push_back(asked.columns[c]);
        for (const LightKnot& knot : asked.knots)
            alone.knots.push_back(knotOf(exchange, *own, knot));
        ofBodies.push_back({find(alone_, std::move(alone)), std::move(numbers)});
    }
    return std::make_shared<const LightSolution>(exchange, asked.columns, asked.knots, ofBodies);
}

LightSolution::LightSolution(const LightExchange& exchange, const std::vector<LightColumn>& columns,
                             const std::vector<LightKnot>& knots, std::span<const OfBody> ofBodies)
    : columns_(columns.size()), knots_(knots.size()) {
    number(exchange, columns);
    const auto take = [&](std::span<const float> from, const OfBody& body, float* to) {
        const std::size_t own = body.columns.size();
        for (std::size_t knot = 0; knot < knots_ && !from.empty(); ++knot)
            for (std::size_t c = 0; c < own; ++c)
                to[knot * columns_ + body.columns[c]] = from[knot * own + c];
    };
    parallelForSmall(receiver_.size(), [&](std::uint32_t p) {
        const std::size_t b = exchange.bodyOf(receiver_[p]);
        take(ofBodies[b].solution->of(receiver_[p] - exchange.firstReceiver(b)), ofBodies[b],
             &gathered_[p * columns_ * knots_]);
    });
    parallelForSmall(exchange.senders(), [&](std::uint32_t s) {
        const std::size_t b = exchange.bodyOfSender(s);
        take(ofBodies[b].solution->ofSender(s - exchange.firstSender(b)), ofBodies[b],
             &ofSenders_[s * columns_ * knots_]);
    });
    if (reflected_ == 0)
        return;
    std::vector<float> leaving(exchange.senders() * sent_);
    for (std::size_t knot = 0; knot < knots_; ++knot) {
        for (std::size_t s = 0; s < exchange.senders(); ++s) {
            const std::size_t b = exchange.bodyOfSender(s);
            const OfBody& body = ofBodies[b];
            const LightExchange& own = *exchange.alone()[b];
            const std::span<const float> from =
                body.solution->of(own.reflected()[s - exchange.firstSender(b)]);
            for (std::size_t c = 0; c < body.columns.size(); ++c)
                if (body.columns[c] < sent_)
                    leaving[s * sent_ + body.columns[c]] = from[knot * body.columns.size() + c];
        }
        takeReflected(LightFactors(exchange, knots[knot]), columns, knot, leaving);
    }
}

} // namespace irsg
