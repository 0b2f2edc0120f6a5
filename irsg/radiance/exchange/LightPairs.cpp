#include "irsg/radiance/exchange/LightPairs.h"

#include <algorithm>
#include <array>

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
    for (unsigned shift = 0; shift < 64; shift += bits) {
        const auto digitOf = [&](const Entry& entry) { return (keyOf(entry) >> shift) % digits; };
        if ((differing >> shift) % digits == 0)
            continue;
        std::array<std::size_t, digits + 1> next{};
        for (std::size_t i = 0; i < count; ++i)
            ++next[digitOf(list[i]) + 1];
        for (std::size_t digit = 0; digit < digits; ++digit)
            next[digit + 1] += next[digit];
        for (std::size_t i = 0; i < count; ++i)
            room[next[digitOf(list[i])]++] = list[i];
        std::copy_n(room.data(), count, list);
    }
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

double LightPairs::sumOf(std::size_t receiver) const {
    const auto [first, last] = of(receiver);
    double sum = 0.0;
    for (const LightPair* pair = first; pair != last; ++pair)
        sum += static_cast<double>(pair->factor);
    return sum;
}

} // namespace irsg
