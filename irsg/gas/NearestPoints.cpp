#include "irsg/gas/NearestPoints.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace irsg {

namespace {

/// The nearest places so far, the farthest of them first (a heap).
class Nearest {
  public:
    explicit Nearest(std::span<NearestPoints::Found> found) : found_(found) {}

    bool canTake(double distance2_m2) const {
        return count_ < found_.size() || distance2_m2 < found_.front().distance2_m2;
    }
    void take(const NearestPoints::Found& one) {
        const auto isNearer = [](const auto& a, const auto& b) {
            return a.distance2_m2 < b.distance2_m2;
        };
        if (count_ == found_.size()) {
            std::ranges::pop_heap(found_, isNearer);
            found_.back() = one;
        } else {
            found_[count_++] = one;
        }
        std::ranges::push_heap(found_.first(count_), isNearer);
    }
    std::size_t sorted() {
        std::ranges::sort(found_.first(count_), [](const auto& a, const auto& b) {
            return std::pair(a.distance2_m2, a.number) < std::pair(b.distance2_m2, b.number);
        });
        return count_;
    }

  private:
    std::span<NearestPoints::Found> found_;
    std::size_t count_ = 0;
};

} // namespace

NearestPoints::NearestPoints(std::vector<GasVector> places_m)
    : places_m_(std::move(places_m)), order_(places_m_.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    for (std::size_t axis = 0; axis < 3 && !places_m_.empty(); ++axis) {
        const auto [least, most] = std::ranges::minmax(
            places_m_, {}, [axis](const GasVector& place_m) { return place_m[axis]; });
        least_m_[axis] = least[axis];
        most_m_[axis] = most[axis];
    }
    order(0, order_.size(), 0);
}

void NearestPoints::order(std::size_t first, std::size_t end, int axis) {
    if (end - first < 2)
        return;
    const std::size_t middle = first + (end - first) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto of = static_cast<std::size_t>(axis);
    std::nth_element(at(first), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(places_m_[a][of], a) < std::pair(places_m_[b][of], b);
    });
    order(first, middle, (axis + 1) % 3);
    order(middle + 1, end, (axis + 1) % 3);
}

std::size_t NearestPoints::nearest(const GasVector& to_m, std::span<Found> found) const {
    Nearest nearest(found);
    // `away_m`: by how much the place is outside a range along each axis (S. Arya and D. M. Mount
    // 1993, Data Compression Conference, 381).
    const auto look = [&](std::size_t first, std::size_t end, std::size_t axis,
                          const GasVector& away_m, const auto& again) -> void {
        if (first == end || !nearest.canTake(dotOf(away_m, away_m)))
            return;
        const std::size_t middle = first + (end - first) / 2;
        const GasVector& at_m = places_m_[order_[middle]];
        const GasVector between_m = differenceOf(at_m, to_m);
        const double distance2_m2 = dotOf(between_m, between_m);
        if (nearest.canTake(distance2_m2))
            nearest.take({distance2_m2, order_[middle]});
        const std::size_t next = (axis + 1) % 3;
        GasVector farther_m = away_m;
        farther_m[axis] = between_m[axis];
        if (between_m[axis] > 0.0) {
            again(first, middle, next, away_m, again);
            again(middle + 1, end, next, farther_m, again);
        } else {
            again(middle + 1, end, next, away_m, again);
            again(first, middle, next, farther_m, again);
        }
    };
    if (!found.empty() && !places_m_.empty()) {
        GasVector away_m{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            away_m[axis] = to_m[axis] - std::clamp(to_m[axis], least_m_[axis], most_m_[axis]);
        look(0, order_.size(), 0, away_m, look);
    }
    return nearest.sorted();
}

} // namespace irsg
