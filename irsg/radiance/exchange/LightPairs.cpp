#include "irsg/radiance/exchange/LightPairs.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "irsg/core/ParallelFor.h"

namespace irsg {

namespace {

/// Adds up what is equal of a sorted list and returns how much is left.
template <typename Entry, typename IsEqual>
std::size_t merge(Entry* list, std::size_t count, IsEqual isEqual) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (kept > 0 && isEqual(list[kept - 1], list[i]))
            list[kept - 1].factor += list[i].factor;
        else
            list[kept++] = list[i];
    return kept;
}

/// Sorts by a key of 64 bits, what is equal in the order in which it came: digit by digit from the
/// last one, without those that are equal everywhere, as most are. Lists are thousands long and
/// their keys a few thousand numbers.
template <typename Entry, typename KeyOf>
void sortByDigits(Entry* list, std::size_t count, KeyOf keyOf) {
    constexpr unsigned bits = 8, digits = 1u << bits;
    std::uint64_t differing = 0;
    for (std::size_t i = 1; i < count; ++i)
        differing |= keyOf(list[i]) ^ keyOf(list[0]);
    std::vector<Entry> room(differing != 0 ? count : 0);
    Entry *from = list, *to = room.data();
    for (unsigned shift = 0; shift < 64; shift += bits) {
        const auto digitOf = [&](const Entry& entry) { return (keyOf(entry) >> shift) % digits; };
        if ((differing >> shift) % digits == 0)
            continue;
        std::array<std::size_t, digits + 1> next{};
        for (std::size_t i = 0; i < count; ++i)
            ++next[digitOf(from[i]) + 1];
        for (std::size_t digit = 0; digit < digits; ++digit)
            next[digit + 1] += next[digit];
        for (std::size_t i = 0; i < count; ++i)
            to[next[digitOf(from[i])]++] = from[i];
        std::swap(from, to);
    }
    if (from != list)
        std::copy_n(from, count, list);
}

/// Of `Columns` columns, whose sums stay at hand until the last pair: to store them after each
/// takes longer than to add.
template <std::size_t Columns>
void gatherColumns(std::span<const LightPair> pairs, const float* sent, std::size_t width,
                   float* arrives) {
    std::array<float, Columns> sums{};
    for (const LightPair& pair : pairs) {
        const float* from = sent + pair.sender * width;
        for (std::size_t c = 0; c < Columns; ++c)
            sums[c] += pair.factor * from[c];
    }
    std::ranges::copy(sums, arrives);
}

} // namespace

void mergeParts(std::vector<LightPart>& parts) {
    sortByDigits(parts.data(), parts.size(), [](const LightPart& part) {
        return std::uint64_t{part.receiver} << 32 | part.sender;
    });
    parts.resize(merge(parts.data(), parts.size(), [](const LightPart& a, const LightPart& b) {
        return a.receiver == b.receiver && a.sender == b.sender;
    }));
    parts.shrink_to_fit();
}

LightPairs::LightPairs(std::size_t receivers, std::vector<std::vector<LightPart>> parts) {
    std::vector<std::size_t> begin(receivers + 1), kept(receivers);
    for (const std::vector<LightPart>& list : parts)
        for (const LightPart& part : list)
            ++begin[part.receiver + 1];
    for (std::size_t r = 0; r < receivers; ++r)
        begin[r + 1] += begin[r];
    std::vector<LightPair> all(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (std::vector<LightPart>& list : parts) {
        for (const LightPart& part : list)
            all[next[part.receiver]++] = {part.sender, part.factor};
        list = {};
    }
    parallelForSmall(receivers, [&](std::uint32_t r) {
        LightPair* own = all.data() + begin[r];
        const std::size_t count = begin[r + 1] - begin[r];
        sortByDigits(own, count, [](const LightPair& pair) { return std::uint64_t{pair.sender}; });
        kept[r] = merge(own, count, [](const LightPair& a, const LightPair& b) {
            return a.sender == b.sender;
        });
    });
    first_.push_back(0);
    for (const std::size_t count : kept)
        first_.push_back(first_.back() + count);
    pairs_.reserve(first_.back());
    for (std::size_t r = 0; r < receivers; ++r)
        pairs_.insert(pairs_.end(), all.begin() + static_cast<std::ptrdiff_t>(begin[r]),
                      all.begin() + static_cast<std::ptrdiff_t>(begin[r] + kept[r]));
}

LightPairs::LightPairs(std::span<const Block> blocks) {
    first_.push_back(0);
    for (const Block& block : blocks)
        for (std::size_t r = block.first; r < block.first + block.count; ++r)
            first_.push_back(
                first_.back() +
                (block.pairs ? block.pairs->first_[r + 1] - block.pairs->first_[r] : 0));
    pairs_.reserve(first_.back());
    for (const Block& block : blocks)
        for (std::size_t i = block.pairs ? block.pairs->first_[block.first] : 0;
             block.pairs && i < block.pairs->first_[block.first + block.count]; ++i) {
            const LightPair& pair = block.pairs->pairs_[i];
            const std::uint32_t sender =
                block.numbers ? (*block.numbers)[pair.sender] : pair.sender + block.addToSenders;
            pairs_.push_back({sender, pair.factor});
        }
}

double LightPairs::sumOf(std::size_t receiver) const {
    const auto [first, last] = of(receiver);
    double sum = 0.0;
    for (const LightPair* pair = first; pair != last; ++pair)
        sum += static_cast<double>(pair->factor);
    return sum;
}

void LightPairs::gather(std::size_t receiver, std::span<const float> sent, std::size_t width,
                        std::size_t count, float* arrives) const {
    const auto [first, last] = of(receiver);
    const std::span<const LightPair> pairs(first, last);
    std::size_t c = 0;
    for (; c + 16 <= count; c += 16)
        gatherColumns<16>(pairs, sent.data() + c, width, arrives + c);
    for (; c + 4 <= count; c += 4)
        gatherColumns<4>(pairs, sent.data() + c, width, arrives + c);
    for (; c < count; ++c)
        gatherColumns<1>(pairs, sent.data() + c, width, arrives + c);
}

void WeightedPairs::gather(std::size_t receiver, std::span<const float> sent, std::size_t width,
                           std::size_t count, float* arrives) const {
    first_->gather(receiver, sent, width, count, arrives);
    thread_local std::vector<float> own;
    for (const auto& [pairs, factor] : others_) {
        if (pairs->isEmpty(receiver))
            continue;
        own.resize(count);
        pairs->gather(receiver, sent, width, count, own.data());
        for (std::size_t c = 0; c < count; ++c)
            arrives[c] += factor * own[c];
    }
}

} // namespace irsg
