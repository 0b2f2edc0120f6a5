#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "irsg/geometry/view/Vec3.h"

namespace irsg {

/// Boxes in a tree, by their places in a list: finds those that touch a box, or that reach beyond a
/// plane, without a look at most of the others.
class FacetTree {
  public:
    /// A box that is not valid is never found.
    explicit FacetTree(std::vector<BoundingBox> boxes);

    /// Calls visit(number) for every box that touches another, in the order of the tree.
    template <typename Visit>
    void forEachTouching(const BoundingBox& box, Visit visit) const {
        search([&](const BoundingBox& own) { return touch(own, box); },
               [&](std::uint32_t number) {
                   visit(number);
                   return false;
               });
    }
    /// Whether isBeyond(number) holds for any of the boxes that reach beyond the plane
    /// dot(normal, x) = offset_m.
    template <typename IsBeyond>
    bool isAnyBeyond(const Vec3& normal, double offset_m, IsBeyond isBeyond) const {
        return search(
            [&](const BoundingBox& own) {
                return (normal.x > 0.0 ? own.max.x : own.min.x) * normal.x +
                           (normal.y > 0.0 ? own.max.y : own.min.y) * normal.y +
                           (normal.z > 0.0 ? own.max.z : own.min.z) * normal.z >
                       offset_m;
            },
            isBeyond);
    }

  private:
    /// A branch is followed by its first child; a leaf has boxes.
    struct Node {
        BoundingBox box;
        std::uint32_t second = 0;           ///< child of a branch
        std::uint32_t first = 0, count = 0; ///< of a leaf: in the list of numbers
    };
    static bool touch(const BoundingBox& a, const BoundingBox& b) {
        return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y &&
               b.min.y <= a.max.y && a.min.z <= b.max.z && b.min.z <= a.max.z;
    }
    /// Until stopsAt(number) holds for a box of those that matter.
    template <typename Matters, typename StopsAt>
    bool search(Matters matters, StopsAt stopsAt) const {
        // Boxes are halved by their number: no way to the leaves is longer.
        std::array<std::uint32_t, 64> open;
        std::size_t count = 0;
        if (!nodes_.empty())
            open[count++] = 0;
        while (count > 0) {
            const std::uint32_t at = open[--count];
            const Node& node = nodes_[at];
            if (!matters(node.box))
                continue;
            if (node.count == 0) {
                open[count++] = node.second;
                open[count++] = at + 1;
            }
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
                if (matters(boxes_[numbers_[i]]) && stopsAt(numbers_[i]))
                    return true;
        }
        return false;
    }
    void build(std::uint32_t first, std::uint32_t count);

    std::vector<BoundingBox> boxes_;
    std::vector<std::uint32_t> numbers_;
    std::vector<Node> nodes_;
};

} // namespace irsg
