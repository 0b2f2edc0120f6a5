#include "irsg/render/rays/FacetTree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace irsg {

namespace {

constexpr std::uint32_t mostInLeaf = 4;

/// The tree of so many boxes.
std::size_t nodesFor(std::size_t count) {
    return count <= mostInLeaf ? 1 : 1 + nodesFor(count / 2) + nodesFor(count - count / 2);
}

} // namespace

void FacetTree::Box::include(const Vec3& place) {
    include(Box{
        {static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z)},
        {static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z)}});
}

void FacetTree::Box::include(const Box& other) {
    if (!isThere())
        *this = other;
    for (std::size_t axis = 0; other.isThere() && axis < 3; ++axis) {
        min[axis] = std::min(min[axis], other.min[axis]);
        max[axis] = std::max(max[axis], other.max[axis]);
    }
}

FacetTree::FacetTree(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    std::vector<std::uint32_t> given; // by place among those that are there
    given.reserve(boxes_.size());
    for (std::uint32_t i = 0; i < boxes_.size(); ++i)
        if (boxes_[i].isThere()) {
            boxes_[given.size()] = boxes_[i];
            given.push_back(i);
        }
    boxes_.resize(given.size());
    if (given.empty())
        return;
    numbers_.resize(given.size());
    std::iota(numbers_.begin(), numbers_.end(), 0u);
    nodes_.reserve(nodesFor(numbers_.size()));
    build(0, static_cast<std::uint32_t>(numbers_.size()));
    putInOrder();
    for (std::uint32_t& number : numbers_)
        number = given[number];
}

/// Boxes of one leaf come to lie side by side, so that a look at them goes to one place in memory.
void FacetTree::putInOrder() {
    std::vector<bool> isDone(numbers_.size());
    for (std::uint32_t start = 0; start < numbers_.size(); ++start) {
        if (isDone[start])
            continue;
        // Each place takes the box that belongs there, and leaves its own to another.
        const Box first = boxes_[start];
        std::uint32_t at = start;
        for (; numbers_[at] != start; at = numbers_[at]) {
            boxes_[at] = boxes_[numbers_[at]];
            isDone[at] = true;
        }
        boxes_[at] = first;
        isDone[at] = true;
    }
}

void FacetTree::build(std::uint32_t first, std::uint32_t count) {
    Box box;
    for (std::uint32_t i = first; i < first + count; ++i)
        box.include(boxes_[numbers_[i]]);
    const std::size_t own = nodes_.size();
    nodes_.push_back({box, first, count});
    if (count <= mostInLeaf)
        return;
    const auto sizeOf = [&](std::size_t axis) {
        return static_cast<double>(box.max[axis]) - static_cast<double>(box.min[axis]);
    };
    const double x = sizeOf(0), y = sizeOf(1), z = sizeOf(2);
    const std::size_t axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    const auto centreOf = [&](std::uint32_t number) {
        return (static_cast<double>(boxes_[number].min[axis]) +
                static_cast<double>(boxes_[number].max[axis])) *
               0.5;
    };
    const std::uint32_t half = count / 2;
    const auto begin = numbers_.begin() + first;
    std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const double atA = centreOf(a), atB = centreOf(b);
        return atA != atB ? atA < atB : a < b;
    });
    nodes_[own].count = 0;
    build(first, half);
    nodes_[own].next = static_cast<std::uint32_t>(nodes_.size());
    build(first + half, count - half);
}

} // namespace irsg
