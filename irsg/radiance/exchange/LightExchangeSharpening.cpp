// What means over nodes take of what is known of them is given back.
#include <algorithm>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/radiance/exchange/LightExchange.h"

namespace irsg {

namespace {

/// Steps of van Cittert's for what senders send, which is reflected again.
constexpr int stepsOfSenders = 3;
/// Steps of Landweber's for what receivers have, which scatters more the more is taken back.
constexpr int stepsOfReceivers = 2;

/// Adds to columns of one what its mean over others takes of them, of those that count.
/// `first`: the number of the first of the body.
void addBesideMean(const LightPairs& smoothing, std::uint32_t one, std::size_t first,
                   const std::vector<bool>& counts, const std::vector<float>& values,
                   std::size_t width, LightExchange::Columns columns, float* own) {
    if (!counts[first + one])
        return;
    const float* const here = &values[(first + one) * width];
    const auto [begin, end] = smoothing.of(one);
    for (const LightPair* pair = begin; pair != end; ++pair) {
        if (!counts[first + pair->sender])
            continue;
        const float* const there = &values[(first + pair->sender) * width];
        for (std::size_t c = columns.first; c < columns.first + columns.count; ++c)
            own[c] += pair->factor * (here[c] - there[c]);
    }
}

} // namespace

void LightExchange::sharpen(std::vector<float>& values, std::size_t width) const {
    // What means M take of the values, without what they leave of it: with d = v - M x, x + M d is
    // nearer to what has the means v. Of what scatters from node to node M leaves little.
    const auto beside = [&](const std::vector<float>& of, std::vector<float>& to) {
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            const LightPairs& smoothing = bodies_[b].light->nodes().smoothing();
            const std::size_t first = firstReceiver_[b];
            parallelForSmall(smoothing.receivers(), [&](std::uint32_t r) {
                addBesideMean(smoothing, r, first, getsLight_, of, width, {0, width},
                              &to[(first + r) * width]);
            });
        }
    };
    const std::vector<float> means = values;
    std::vector<float> difference(values.size()), taken(values.size());
    for (int step = 0; step < stepsOfReceivers; ++step) {
        for (std::size_t i = 0; i < values.size(); ++i)
            difference[i] = means[i] - values[i];
        beside(values, difference);
        std::ranges::fill(taken, 0.0f);
        beside(difference, taken);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] += difference[i] - taken[i];
    }
}

void LightExchange::sharpenSent(std::vector<float>& values, std::size_t width,
                                std::span<const Columns> ofBodies,
                                const std::vector<bool>& counts) const {
    std::vector<float> rest = values, next(values.size());
    for (int step = 0; step < stepsOfSenders; ++step) {
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            const LightPairs& smoothing = bodies_[b].light->nodes().smoothingOfSenders();
            const std::size_t first = firstSender_[b];
            const Columns columns = ofBodies[b];
            parallelForSmall(smoothing.receivers(), [&](std::uint32_t s) {
                const std::size_t at = (first + s) * width;
                std::fill_n(&next[at], width, 0.0f);
                addBesideMean(smoothing, s, first, counts, rest, width, columns, &next[at]);
                for (std::size_t c = columns.first; c < columns.first + columns.count; ++c)
                    values[at + c] += next[at + c];
            });
        }
        std::swap(rest, next);
    }
}

void LightExchange::sharpenSent(std::vector<double>& values,
                                const std::vector<bool>& counts) const {
    std::vector<float> sharpened(values.begin(), values.end());
    sharpenSent(sharpened, 1, std::vector<Columns>(bodies_.size(), {0, 1}), counts);
    std::ranges::copy(sharpened, values.begin());
}

} // namespace irsg
