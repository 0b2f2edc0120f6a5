#include "tests/support/FacetTree.h"

#include <array>
#include <cstddef>

namespace irsg::test::tracing {

namespace {

double component(const Vec3& v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// Moeller and Trumbore 1997. Shortens the hit.
bool meets(const Facet& facet, const Ray& ray, Stops stops, Hit& hit) {
    const Vec3 p = cross(ray.direction, facet.edge2_m);
    const double determinant = dot(facet.edge1_m, p);
    if (determinant == 0.0) {
        return false;
    }
    const bool isFront = determinant > 0.0;
    if (!facet.isTwoSided && isFront != (stops == Stops::whereFrontIsSeen)) {
        return false;
    }
    const double per = 1.0 / determinant;
    const Vec3 s = ray.start_m - facet.corner_m;
    const double u = dot(s, p) * per;
    constexpr double seam = 1e-12; // no ray slips between two facets
    if (u < -seam || u > 1.0 + seam) {
        return false;
    }
    const Vec3 q = cross(s, facet.edge1_m);
    const double v = dot(ray.direction, q) * per;
    if (v < -seam || u + v > 1.0 + seam) {
        return false;
    }
    const double t = dot(facet.edge2_m, q) * per;
    if (!(t > 0.0 && t < hit.distance_m)) {
        return false;
    }
    hit.distance_m = t;
    hit.isFront = isFront;
    return true;
}

} // namespace

Hit FacetTree::nearest(const Ray& ray, std::uint32_t from) const {
    Hit hit;
    walk(ray, from, nothing, Stops::whereFrontIsSeen, hit, false);
    return hit;
}
bool FacetTree::isBlocked(const Ray& ray, double distance_m, std::uint32_t from, std::uint32_t to,
                          Stops stops) const {
    Hit hit;
    hit.distance_m = distance_m;
    walk(ray, from, to, stops, hit, true);
    return hit.facet != nothing;
}

void FacetTree::walk(const Ray& ray, std::uint32_t from, std::uint32_t to, Stops stops, Hit& hit,
                     bool isAnyEnough) const {
    const auto inverse = [](double d) { return 1.0 / (std::abs(d) > 1e-200 ? d : 1e-200); };
    const Vec3 per{inverse(ray.direction.x), inverse(ray.direction.y), inverse(ray.direction.z)};
    const std::array<bool, 3> isBackward{per.x < 0.0, per.y < 0.0, per.z < 0.0};
    std::array<std::uint32_t, 128> later;
    std::size_t waiting = 0;
    std::uint32_t number = 0;
    while (true) {
        const Node& node = nodes_[number];
        if (isMet(node, ray.start_m, per, hit.distance_m)) {
            if (node.count == 0) {
                const bool secondFirst = isBackward[static_cast<std::size_t>(node.axis)];
                later[waiting++] = secondFirst ? number + 1 : node.first;
                number = secondFirst ? node.first : number + 1;
                continue;
            }
            for (std::uint32_t f = node.first; f < node.first + node.count; ++f) {
                if (f == from || f == to || !meets(facets_[f], ray, stops, hit)) {
                    continue;
                }
                hit.facet = f;
                if (isAnyEnough) {
                    return;
                }
            }
        }
        if (waiting == 0) {
            return;
        }
        number = later[--waiting];
    }
}

bool FacetTree::isMet(const Node& node, const Vec3& start_m, const Vec3& per, double most_m) {
    const double x1 = (node.low_m.x - start_m.x) * per.x, x2 = (node.high_m.x - start_m.x) * per.x;
    const double y1 = (node.low_m.y - start_m.y) * per.y, y2 = (node.high_m.y - start_m.y) * per.y;
    const double z1 = (node.low_m.z - start_m.z) * per.z, z2 = (node.high_m.z - start_m.z) * per.z;
    const double enters =
        std::max(std::max(std::min(x1, x2), std::min(y1, y2)), std::max(std::min(z1, z2), 0.0));
    const double leaves =
        std::min(std::min(std::max(x1, x2), std::max(y1, y2)), std::min(std::max(z1, z2), most_m));
    return enters <= leaves;
}

/// Halves of least surface times number, over 16 classes along each axis.
FacetTree::FacetTree(const std::vector<Facet>& from) {
    std::vector<std::uint32_t> order(from.size());
    for (std::uint32_t f = 0; f < order.size(); ++f) {
        order[f] = f;
    }
    facets_.reserve(from.size());
    struct Box {
        Vec3 low{infinitelyFar, infinitelyFar, infinitelyFar},
            high{-infinitelyFar, -infinitelyFar, -infinitelyFar};
        void add(const Vec3& p) { low = least(low, p), high = greatest(high, p); }
        void add(const Box& o) { low = least(low, o.low), high = greatest(high, o.high); }
        double surface() const {
            const Vec3 side = high - low;
            return side.x < 0.0 ? 0.0 : side.x * side.y + side.y * side.z + side.z * side.x;
        }
    };
    const auto boxOf = [&](std::uint32_t f) {
        Box box;
        box.add(from[f].corner_m);
        box.add(from[f].corner_m + from[f].edge1_m);
        box.add(from[f].corner_m + from[f].edge2_m);
        return box;
    };
    const auto middleOf = [&](std::uint32_t f, int axis) {
        return component(from[f].corner_m, axis) +
               (component(from[f].edge1_m, axis) + component(from[f].edge2_m, axis)) / 3.0;
    };
    struct Task {
        std::uint32_t first, end, parent; ///< whose second child it is, or nothing
        int depth;
    };
    std::vector<Task> tasks{{0, static_cast<std::uint32_t>(from.size()), nothing, 0}};
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        const auto number = static_cast<std::uint32_t>(nodes_.size());
        if (task.parent != nothing) {
            nodes_[task.parent].first = number;
        }
        Box box, middles;
        for (std::uint32_t i = task.first; i < task.end; ++i) {
            box.add(boxOf(order[i]));
            middles.add(Vec3{middleOf(order[i], 0), middleOf(order[i], 1), middleOf(order[i], 2)});
        }
        const double pad = 1e-12 * (1.0 + norm(box.high - box.low) + norm(box.high));
        Node node;
        node.low_m = box.low - Vec3{pad, pad, pad};
        node.high_m = box.high + Vec3{pad, pad, pad};
        const std::uint32_t count = task.end - task.first;
        constexpr int classes = 16;
        double best = infinitelyFar, bestPlace = 0.0;
        // Below 64 halves of halves the numbers are halved, so that the waiting ones of walk()
        // suffice.
        for (int axis = 0; axis < 3 && count > 2 && task.depth < 64; ++axis) {
            const double low = component(middles.low, axis), high = component(middles.high, axis);
            if (!(high > low)) {
                continue;
            }
            std::array<Box, classes> boxes;
            std::array<std::uint32_t, classes> counts{};
            for (std::uint32_t i = task.first; i < task.end; ++i) {
                const auto c = static_cast<std::size_t>(std::min(
                    classes - 1.0, classes * (middleOf(order[i], axis) - low) / (high - low)));
                boxes[c].add(boxOf(order[i]));
                ++counts[c];
            }
            std::array<double, classes> before{};
            Box sum;
            std::uint32_t many = 0;
            for (std::size_t c = 0; c + 1 < classes; ++c) {
                sum.add(boxes[c]), many += counts[c];
                before[c] = sum.surface() * many;
            }
            sum = {}, many = 0;
            for (std::size_t c = classes - 1; c > 0; --c) {
                sum.add(boxes[c]), many += counts[c];
                const double cost = before[c - 1] + sum.surface() * many;
                if (cost < best && many > 0 && many < count) {
                    best = cost;
                    node.axis = axis;
                    bestPlace = low + (high - low) * static_cast<double>(c) / classes;
                }
            }
        }
        const bool isLeaf = count <= 2 || best == infinitelyFar ||
                            (count <= 8 && best + box.surface() >= box.surface() * count);
        const std::uint32_t* middle = nullptr;
        if (!isLeaf || count > 64) {
            if (best < infinitelyFar) {
                middle = std::partition(
                    order.data() + task.first, order.data() + task.end,
                    [&](std::uint32_t f) { return middleOf(f, node.axis) < bestPlace; });
            }
            if (middle == nullptr || middle == order.data() + task.first ||
                middle == order.data() + task.end) {
                middle = order.data() + task.first + count / 2;
            }
        }
        if (middle == nullptr) {
            node.count = count;
            node.first = static_cast<std::uint32_t>(facets_.size());
            for (std::uint32_t i = task.first; i < task.end; ++i) {
                facets_.push_back(from[order[i]]);
            }
            nodes_.push_back(node);
            continue;
        }
        const auto split = static_cast<std::uint32_t>(middle - order.data());
        nodes_.push_back(node);
        tasks.push_back({split, task.end, number, task.depth + 1});
        tasks.push_back({task.first, split, nothing, task.depth + 1}); // follows its parent
    }
}

} // namespace irsg::test::tracing
