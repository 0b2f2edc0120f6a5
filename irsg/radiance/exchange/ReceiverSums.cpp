#include "irsg/radiance/exchange/ReceiverSums.h"

#include <algorithm>
#include <utility>

namespace irsg {

ReceiverSums::ReceiverSums(std::vector<Entry> entries) : entries_(std::move(entries)) {
    std::ranges::sort(entries_, {}, &Entry::receiver);
}

void ReceiverSums::addScaled(const ReceiverSums& other, double scale) {
    std::vector<Entry> all;
    all.reserve(entries_.size() + other.entries_.size());
    auto own = entries_.begin();
    for (const Entry& added : other.entries_) {
        while (own != entries_.end() && own->receiver < added.receiver)
            all.push_back(*own++);
        Entry sum{added.receiver, {}};
        if (own != entries_.end() && own->receiver == added.receiver)
            sum.weights = (own++)->weights;
        for (std::size_t q = 0; q < sum.weights.size(); ++q)
            sum.weights[q] += scale * added.weights[q];
        all.push_back(sum);
    }
    all.insert(all.end(), own, entries_.end());
    entries_ = std::move(all);
}

void addLight(const LightSums& light, double scale, LightSums& to) {
    for (const auto& [kind, sums] : light)
        to[kind].addScaled(sums, scale);
}

std::size_t ReceiverSumsMaker::addFront() {
    if (fronts_ == width_) {
        std::vector<ReceiverSums::Weights> wider(2 * weights_.size());
        for (std::size_t i = 0; i < receivers_.size(); ++i)
            std::copy_n(&weights_[i * width_], width_, &wider[i * 2 * width_]);
        weights_ = std::move(wider);
        width_ *= 2;
    }
    return fronts_++;
}

ReceiverSums ReceiverSumsMaker::sumsOf(std::size_t front) const {
    std::vector<ReceiverSums::Entry> entries;
    for (std::size_t i = 0; i < receivers_.size(); ++i)
        if (const ReceiverSums::Weights& own = weights_[i * width_ + front];
            own != ReceiverSums::Weights{})
            entries.push_back({receivers_[i], own});
    return ReceiverSums(std::move(entries));
}

void ReceiverSumsMaker::grow() {
    constexpr std::size_t fewest = 16;
    places_.assign(std::max(fewest, 2 * places_.size()), none);
    shift_ = 32;
    for (std::size_t size = places_.size(); size > 1; size /= 2)
        --shift_;
    for (std::size_t i = 0; i < receivers_.size(); ++i) {
        std::size_t place = placeOf(receivers_[i]);
        while (places_[place] != none)
            place = (place + 1) & (places_.size() - 1);
        places_[place] = static_cast<std::uint32_t>(i);
    }
}

} // namespace irsg
