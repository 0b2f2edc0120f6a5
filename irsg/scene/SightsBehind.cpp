#include "irsg/scene/SightsBehind.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

constexpr double zenith_rad = 0.5 * std::numbers::pi;
/// Air masses of the sky go with 1 / (angle from the horizon + about this).
constexpr double nearHorizon_rad = 0.02;
/// An object that is narrower than this part of that angle needs one line of sight.
constexpr double narrow = 0.0005;
/// How far from the horizon the rows beside it lie.
constexpr double besideHorizon_rad = 6e-9;
/// Of the background: what more rows may change.
constexpr double neededChange = 1e-5;
/// What is left of a change when rows are doubled: the rule is of third order at least.
constexpr double ofNextChange = 0.25;
constexpr std::size_t mostRows = 65;

/// Rows on one side of the horizon.
struct Side {
    double sign, nearest_rad, farthest_rad;
    bool isRoot; ///< even in the root of the angle

    double place(double angle_rad) const {
        const auto of = [&](double x) { return isRoot ? std::sqrt(x) : x; };
        return std::clamp((of(angle_rad) - of(nearest_rad)) / (of(farthest_rad) - of(nearest_rad)),
                          0.0, 1.0);
    }
    double angle_rad(double place) const {
        if (!isRoot)
            return nearest_rad + place * (farthest_rad - nearest_rad);
        const double root =
            std::sqrt(nearest_rad) + place * (std::sqrt(farthest_rad) - std::sqrt(nearest_rad));
        return root * root;
    }
};

std::vector<Side> sidesOf(double lowest_rad, double highest_rad, double horizon_rad) {
    const double above_rad = highest_rad - horizon_rad, below_rad = horizon_rad - lowest_rad;
    std::vector<Side> sides;
    if (above_rad > 0.0)
        sides.push_back({1.0, std::max(-below_rad, 0.0), above_rad, false});
    if (below_rad > 0.0)
        sides.push_back({-1.0, std::max(-above_rad, 0.0), below_rad, above_rad > 0.0});
    return sides;
}

/// Weights of `rows` rows on a side for slices: parabolas through three rows each; with two rows a
/// straight line. `slices`: place along the side and weight.
std::vector<double> weightsOf(const std::vector<std::pair<double, double>>& slices,
                              std::size_t rows) {
    std::vector<double> weights(rows, 0.0);
    for (const auto& [place, weight] : slices) {
        if (rows == 2) {
            weights[0] += weight * (1.0 - place);
            weights[1] += weight * place;
            continue;
        }
        const std::size_t panels = (rows - 1) / 2;
        const double scaled = place * static_cast<double>(panels);
        const std::size_t panel = std::min(static_cast<std::size_t>(scaled), panels - 1);
        const double t = 2.0 * (scaled - static_cast<double>(panel)); // 0 to 2
        weights[2 * panel] += weight * 0.5 * (t - 1.0) * (t - 2.0);
        weights[2 * panel + 1] += weight * t * (2.0 - t);
        weights[2 * panel + 2] += weight * 0.5 * t * (t - 1.0);
    }
    return weights;
}

/// What is behind an object with so many rows on each side.
struct Behind {
    std::vector<SightBehind> sights;
    std::vector<double> mean, least, most; ///< by output
};

class Rows {
  public:
    Rows(const ObjectGeometry& object, double horizon_rad, std::vector<Side> sides,
         const std::vector<SilhouettePart>& slices, const RadianceAlong& radianceAlong)
        : object_(object),
          horizon_rad_(horizon_rad),
          sides_(std::move(sides)),
          slices_(sides_.size()),
          radianceAlong_(radianceAlong) {
        double all = 0.0;
        for (const SilhouettePart& slice : slices) {
            const double above_rad = object.sight.elevation_rad + slice.above_rad - horizon_rad;
            // What lies below the horizon of an object that is partly behind it is hidden.
            if (object.hidden == HiddenPart::some && above_rad < 0.0)
                continue;
            const std::size_t side = sides_.size() > 1 && above_rad < 0.0 ? 1 : 0;
            const double angle_rad = std::max(sides_[side].sign * above_rad, 0.0);
            slices_[side].emplace_back(sides_[side].place(angle_rad), slice.weight);
            all += slice.weight;
        }
        for (auto& ofSide : slices_)
            for (auto& [place, weight] : ofSide)
                weight /= all;
        isSeen_ = all > 0.0;
    }

    bool isSeen() const { return isSeen_; }
    Behind behind(std::size_t rows) const {
        Behind behind;
        for (std::size_t s = 0; s < sides_.size(); ++s) {
            const std::vector<double> weights = weightsOf(slices_[s], rows);
            for (std::size_t row = 0; row < rows; ++row) {
                if (std::abs(weights[row]) < 1e-9)
                    continue;
                const double place = static_cast<double>(row) / static_cast<double>(rows - 1);
                add(sides_[s], sides_[s].angle_rad(place), weights[row], behind);
            }
        }
        return behind;
    }

  private:
    void add(const Side& side, double angle_rad, double weight, Behind& behind) const {
        LineOfSight sight = object_.sight;
        sight.elevation_rad =
            std::clamp(horizon_rad_ + side.sign * std::max(angle_rad, besideHorizon_rad),
                       -zenith_rad, zenith_rad);
        sight = steadied(sight);
        // Rounding must not lead across the horizon.
        if ((sight.elevation_rad - horizon_rad_) * side.sign <= 0.0)
            sight.elevation_rad = horizon_rad_ + side.sign * besideHorizon_rad;
        const std::vector<double> seen = radianceAlong_(sight);
        if (behind.mean.empty()) {
            behind.mean.assign(seen.size(), 0.0);
            behind.least = behind.most = seen;
        }
        for (std::size_t k = 0; k < seen.size(); ++k) {
            behind.mean[k] += weight * seen[k];
            behind.least[k] = std::min(behind.least[k], seen[k]);
            behind.most[k] = std::max(behind.most[k], seen[k]);
        }
        behind.sights.push_back({sight, weight});
    }

    const ObjectGeometry& object_;
    double horizon_rad_;
    std::vector<Side> sides_;
    std::vector<std::vector<std::pair<double, double>>> slices_; ///< by side
    const RadianceAlong& radianceAlong_;
    bool isSeen_ = false;
};

SightsBehind doubledAsNeeded(const Rows& rows) {
    Behind coarser = rows.behind(2), finer = rows.behind(3);
    std::vector<double> left(finer.mean.size(), 0.0);
    for (std::size_t count = 3;; count = 2 * count - 1) {
        // From straight lines to parabolas more changes than from these to more of them.
        const double ofChange = count == 3 ? 0.125 : ofNextChange;
        bool isEnough = true;
        for (std::size_t k = 0; k < left.size(); ++k) {
            left[k] = ofChange * std::abs(finer.mean[k] - coarser.mean[k]);
            isEnough = isEnough && left[k] <= neededChange * std::abs(finer.mean[k]);
        }
        if (isEnough || 2 * count - 1 > mostRows)
            break;
        coarser = std::move(finer);
        finer = rows.behind(2 * count - 1);
    }
    for (std::size_t k = 0; k < left.size(); ++k)
        left[k] += errorOfOverlap * (finer.most[k] - finer.least[k]);
    return {std::move(finer.sights), std::move(left)};
}

} // namespace

SightsBehind sightsBehind(const ObjectGeometry& object, double horizon_rad, double reach_rad,
                          const std::function<std::vector<SilhouettePart>()>& slices,
                          const RadianceAlong& radianceAlong) {
    const double middle_rad = object.sight.elevation_rad;
    const auto alone = [&] {
        const std::vector<double> seen = radianceAlong(object.sight);
        return SightsBehind{{{object.sight, 1.0}}, std::vector<double>(seen.size(), 0.0)};
    };
    if (reach_rad <= narrow * (std::abs(middle_rad - horizon_rad) + nearHorizon_rad))
        return alone();
    try {
        const Rows rows(object, horizon_rad,
                        sidesOf(std::max(middle_rad - reach_rad, -zenith_rad),
                                std::min(middle_rad + reach_rad, zenith_rad), horizon_rad),
                        slices(), radianceAlong);
        return rows.isSeen() ? doubledAsNeeded(rows) : alone();
    } catch (const InputError&) {
        return alone();
    }
}

} // namespace irsg
