#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"

namespace irsg {

/// Boxes in a tree, by their places in a list: finds those that touch a box, or some that reach
/// beyond a plane, without a look at most of the others.
class FacetTree {
  public:
    /// Around places in single precision, which it holds as they are; one of no places is never
    /// found.
    struct Box {
        Float3 min{1.0f, 1.0f, 1.0f}, max{-1.0f, -1.0f, -1.0f};
        void include(const Vec3& place);
        void include(const Box& other);
        bool isThere() const { return min[0] <= max[0]; }
    };
    explicit FacetTree(std::vector<Box> boxes);

    static bool touch(const Box& a, const BoundingBox& b) {
        const auto meet = [&](std::size_t axis, double low, double high) {
            return static_cast<double>(a.min[axis]) <= high &&
                   low <= static_cast<double>(a.max[axis]);
        };
        return meet(0, b.min.x, b.max.x) && meet(1, b.min.y, b.max.y) && meet(2, b.min.z, b.max.z);
    }

    /// Calls visit(number, its box) for every box that touches another, in the order of the tree.
    template <typename Visit>
    void forEachTouching(const BoundingBox& box, Visit visit) const {
        // Boxes are halved by their number: no way to the leaves is longer.
        std::array<std::uint32_t, 64> open;
        std::size_t count = 0;
        if (!nodes_.empty())
            open[count++] = 0;
        while (count > 0) {
            const std::uint32_t at = open[--count];
            const Node& node = nodes_[at];
            if (!touch(node.box, box))
                continue;
            if (node.count == 0) {
                open[count++] = node.next;
                open[count++] = at + 1;
            }
            for (std::uint32_t i = node.next; i < node.next + node.count; ++i)
                if (touch(boxes_[i], box))
                    visit(numbers_[i], boxes_[i]);
        }
    }
    /// Whether isBeyond(number, isWhole) holds for any of the boxes that reach beyond the plane
    /// dot(normal, x) = offset_m, or there are more than `mostLooks` of them. `isWhole`: they lie
    /// beyond it as a whole, by `margin_m`; of those below one node one is asked for first.
    template <typename IsBeyond>
    bool isAnyBeyond(const Vec3& normal, double offset_m, double margin_m, IsBeyond isBeyond) const;
    static constexpr std::size_t mostLooks = 256;

  private:
    /// A branch is followed by its first child; a leaf has boxes.
    struct Node {
        Box box;
        std::uint32_t next = 0;  ///< of a branch its second child, of a leaf in the list of numbers
        std::uint32_t count = 0; ///< of a leaf's boxes; 0: a branch
    };
    /// How far a box reaches along a direction: from, to.
    static std::pair<double, double> reachOf(const Box& box, const Vec3& along) {
        double least = 0.0, most = 0.0;
        const auto add = [&](std::size_t axis, double component) {
            const double a = static_cast<double>(box.min[axis]) * component;
            const double b = static_cast<double>(box.max[axis]) * component;
            least += std::min(a, b);
            most += std::max(a, b);
        };
        add(0, along.x), add(1, along.y), add(2, along.z);
        return {least, most};
    }
    /// One of the boxes below a node.
    std::uint32_t anyBelow(std::uint32_t node) const {
        while (nodes_[node].count == 0)
            ++node;
        return numbers_[nodes_[node].next];
    }
    void build(std::uint32_t first, std::uint32_t count);

    void putInOrder();

    std::vector<Box> boxes_;             ///< those that are there, in the order of the tree
    std::vector<std::uint32_t> numbers_; ///< of each, its place in the list
    std::vector<Node> nodes_;
};

template <typename IsBeyond>
bool FacetTree::isAnyBeyond(const Vec3& normal, double offset_m, double margin_m,
                            IsBeyond isBeyond) const {
    struct Open {
        std::uint32_t node = 0;
        double least_m = 0.0;
    };
    std::array<Open, 64> open; // as of boxes that touch
    std::size_t count = 0, looks = 0;
    std::array<std::uint32_t, mostLooks> partly; // who lie beyond as a whole mostly decide before
    const auto push = [&](std::uint32_t node, const std::pair<double, double>& reach_m) {
        if (reach_m.second > offset_m)
            open[count++] = {node, reach_m.first};
    };
    if (!nodes_.empty())
        push(0, reachOf(nodes_.front().box, normal));
    while (count > 0) {
        const auto [at, least_m] = open[--count];
        if (least_m > offset_m + margin_m && isBeyond(anyBelow(at), true))
            return true;
        const Node& node = nodes_[at];
        if (node.count == 0) {
            const auto first_m = reachOf(nodes_[at + 1].box, normal),
                       second_m = reachOf(nodes_[node.next].box, normal);
            // The one that reaches farther is looked at first.
            const bool isFirst = first_m.second > second_m.second;
            push(isFirst ? node.next : at + 1, isFirst ? second_m : first_m);
            push(isFirst ? at + 1 : node.next, isFirst ? first_m : second_m);
            continue;
        }
        for (std::uint32_t i = node.next; i < node.next + node.count; ++i) {
            const auto reach_m = reachOf(boxes_[i], normal);
            if (!(reach_m.second > offset_m))
                continue;
            if (reach_m.first > offset_m + margin_m && isBeyond(numbers_[i], true))
                return true;
            if (looks == mostLooks)
                return true;
            partly[looks++] = numbers_[i];
        }
    }
    return std::any_of(partly.begin(), partly.begin() + looks,
                       [&](std::uint32_t number) { return isBeyond(number, false); });
}

} // namespace irsg
