#include "irsg/scattering/PixelHaze.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr double taperShare = 0.25;
/// Nearest distance that is asked for: half a pixel is that of the first neighbour.
constexpr double nearest_px = 0.4;
/// Steps of the radial table, as a part of the distance and in pixels.
constexpr double widestStep = 0.02, narrowestStep_px = 0.25;
/// Around the point pixels are integrated with many nodes, elsewhere with few.
constexpr int closeBelow_px = 6, nodesClose = 12, nodesFar = 3;

/// Density per square pixel by distance, as a cubic through values and parabolic slopes.
class RadialTable {
  public:
    RadialTable(const HazeFunction& function, double pitch_rad, double end_px) {
        const double ripple_px =
            function.endsSharply()
                ? std::max(1.0 / (8.0 * function.highestFrequency_per_rad() * pitch_rad),
                           narrowestStep_px)
                : end_px;
        for (double r = nearest_px; r < end_px + 1.0;) {
            at_px_.push_back(r);
            r += std::min(widestStep * r, ripple_px);
        }
        while (at_px_.size() < 3)
            at_px_.push_back(at_px_.back() + narrowestStep_px);
        values_.resize(at_px_.size());
        slopes_.resize(at_px_.size());
        parallelFor(at_px_.size(), [&](std::size_t i) {
            values_[i] = function.density_sr(at_px_[i] * pitch_rad) * pitch_rad * pitch_rad;
        });
        for (std::size_t i = 0; i < at_px_.size(); ++i)
            slopes_[i] = slopeAt(std::clamp<std::size_t>(i, 1, at_px_.size() - 2), i);
    }

    double at(double r) const {
        const auto [i, k, t] = bracket(at_px_, r, Beyond::extrapolate);
        const double h = at_px_[k] - at_px_[i], s = 1.0 - t;
        return values_[i] * s * s * (1.0 + 2.0 * t) + values_[k] * t * t * (1.0 + 2.0 * s) +
               h * t * s * (slopes_[i] * s - slopes_[k] * t);
    }

  private:
    /// Of the parabola through the neighbours of `middle`, at node `i`.
    double slopeAt(std::size_t middle, std::size_t i) const {
        const double h0 = at_px_[middle] - at_px_[middle - 1];
        const double h1 = at_px_[middle + 1] - at_px_[middle];
        const double d0 = (values_[middle] - values_[middle - 1]) / h0;
        const double d1 = (values_[middle + 1] - values_[middle]) / h1;
        const double bend = (d1 - d0) / (h0 + h1);
        return d0 + bend * (h0 + 2.0 * (at_px_[i] - at_px_[middle]));
    }

    std::vector<double> at_px_, values_, slopes_;
};

double taper(double r_px, double from_px, double to_px) {
    if (r_px <= from_px)
        return 1.0;
    if (r_px >= to_px)
        return 0.0;
    return 0.5 * (1.0 + std::cos(pi * (r_px - from_px) / (to_px - from_px)));
}

/// Energy under the taper: the integral of w dE, by parts -Int w' E.
double taperedEnergy(const HazeFunction& function, double pitch_rad, double from_px, double to_px) {
    constexpr int panels = 16;
    const GaussRule& rule = gaussLegendre(16);
    const double width_px = (to_px - from_px) / panels;
    std::vector<double> sums(panels, 0.0);
    parallelFor(panels, [&](std::size_t panel) {
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
            const double r = from_px + width_px * (static_cast<double>(panel) + rule.nodes[k]);
            const double fall =
                0.5 * pi / (to_px - from_px) * std::sin(pi * (r - from_px) / (to_px - from_px));
            sums[panel] += width_px * rule.weights[k] * fall * function.energyWithin(r * pitch_rad);
        }
    });
    double energy = 0.0;
    for (const double sum : sums)
        energy += sum;
    return energy;
}

} // namespace

PixelHaze::PixelHaze(const HazeFunction& function, double pitch_rad, int support_px)
    : support_px_(support_px), taperFrom_px_((1.0 - taperShare) * support_px) {
    if (!(pitch_rad > 0.0) || support_px < 1)
        throw LogicError("the haze of a pixel needs a pitch and a support");
    static std::atomic<std::size_t> keys{0};
    key_ = ++keys;

    const RadialTable table(function, pitch_rad, support_px);
    const auto side = static_cast<std::size_t>(support_px) + 1;
    quadrant_.assign(side * side, 0.0);
    parallelFor(side, [&](std::size_t row) {
        // One octant is integrated and mirrored, so that the symmetry is exact.
        const auto y = static_cast<int>(row);
        for (int x = y; x <= support_px_; ++x) {
            if ((x == 0 && y == 0) || std::hypot(x - 0.5, std::max(y - 0.5, 0.0)) >= support_px_)
                continue;
            const GaussRule& rule =
                gaussLegendre(std::max(x, y) < closeBelow_px ? nodesClose : nodesFar);
            double sum = 0.0;
            for (std::size_t j = 0; j < rule.nodes.size(); ++j)
                for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                    const double r = std::hypot(x - 0.5 + rule.nodes[i], y - 0.5 + rule.nodes[j]);
                    sum += rule.weights[i] * rule.weights[j] * table.at(r) *
                           taper(r, taperFrom_px_, support_px_);
                }
            quadrant_[row * side + static_cast<std::size_t>(x)] = sum;
            quadrant_[static_cast<std::size_t>(x) * side + row] = sum;
        }
    });
    // The point's own pixel has what the others leave: at it the density may be almost a pole.
    energy_ = taperedEnergy(function, pitch_rad, taperFrom_px_, support_px_);
    cut_ = function.energy() - energy_;
    double others = 0.0;
    for (int y = 0; y <= support_px_; ++y)
        for (int x = 0; x <= support_px_; ++x)
            others += (x > 0 ? 2.0 : 1.0) * (y > 0 ? 2.0 : 1.0) * at(x, y);
    quadrant_.front() = energy_ - others;
}

double PixelHaze::at(int dx, int dy) const {
    const int x = std::abs(dx), y = std::abs(dy);
    if (x > support_px_ || y > support_px_)
        return 0.0;
    return quadrant_[static_cast<std::size_t>(y) * (static_cast<std::size_t>(support_px_) + 1) +
                     static_cast<std::size_t>(x)];
}

} // namespace irsg
