#include "irsg/render/rays/FacetTree.h"

#include <algorithm>
#include <utility>

namespace irsg {

namespace {

constexpr std::uint32_t mostInLeaf = 4;

double along(const Vec3& v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

} // namespace

FacetTree::FacetTree(std::vector<BoundingBox> boxes) : boxes_(std::move(boxes)) {
    for (std::uint32_t i = 0; i < boxes_.size(); ++i)
        if (boxes_[i].valid())
            numbers_.push_back(i);
    if (!numbers_.empty())
        build(0, static_cast<std::uint32_t>(numbers_.size()));
}

void FacetTree::build(std::uint32_t first, std::uint32_t count) {
    BoundingBox box = BoundingBox::nowhere();
    for (std::uint32_t i = first; i < first + count; ++i)
        box.include(boxes_[numbers_[i]]);
    const std::size_t own = nodes_.size();
    nodes_.push_back({box, 0, first, count});
    if (count <= mostInLeaf)
        return;
    const Vec3 size = box.max - box.min;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t half = count / 2;
    const auto begin = numbers_.begin() + first;
    std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const double atA = along(boxes_[a].centre(), axis), atB = along(boxes_[b].centre(), axis);
        return atA != atB ? atA < atB : a < b;
    });
    nodes_[own].count = 0;
    build(first, half);
    nodes_[own].second = static_cast<std::uint32_t>(nodes_.size());
    build(first + half, count - half);
}

} // namespace irsg
