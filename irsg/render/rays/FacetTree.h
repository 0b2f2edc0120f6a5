#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"

namespace irsg {

/// Boxes in a tree, by their places in a list: finds those that touch a box, or that reach beyond a
/// plane, without a look at most of the others.
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

    /// Calls visit(number) for every box that touches another, in the order of the tree.
    template <typename Visit>
    void forEachTouching(const BoundingBox& box, Visit visit) const {
        search([&](const Box& own) { return touch(own, box); },
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
            [&](const Box& own) {
                const auto most = [&](double along, std::size_t axis) {
                    return static_cast<double>(along > 0.0 ? own.max[axis] : own.min[axis]) * along;
                };
                return most(normal.x, 0) + most(normal.y, 1) + most(normal.z, 2) > offset_m;
            },
            isBeyond);
    }

  private:
    /// A branch is followed by its first child; a leaf has boxes.
    struct Node {
        Box box;
        std::uint32_t next = 0;  ///< of a branch its second child, of a leaf in the list of numbers
        std::uint32_t count = 0; ///< of a leaf's boxes; 0: a branch
    };
    static bool touch(const Box& a, const BoundingBox& b) {
        const auto meet = [&](std::size_t axis, double low, double high) {
            return static_cast<double>(a.min[axis]) <= high &&
                   low <= static_cast<double>(a.max[axis]);
        };
        return meet(0, b.min.x, b.max.x) && meet(1, b.min.y, b.max.y) && meet(2, b.min.z, b.max.z);
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
                open[count++] = node.next;
                open[count++] = at + 1;
            }
            for (std::uint32_t i = node.next; i < node.next + node.count; ++i)
                if (matters(boxes_[numbers_[i]]) && stopsAt(numbers_[i]))
                    return true;
        }
        return false;
    }
    void build(std::uint32_t first, std::uint32_t count);

    std::vector<Box> boxes_;
    std::vector<std::uint32_t> numbers_;
    std::vector<Node> nodes_;
};

} // namespace irsg
