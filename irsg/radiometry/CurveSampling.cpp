#include "irsg/radiometry/CurveSampling.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

constexpr int mostParts = 16;
constexpr int deepest = 12;
constexpr double narrowest = 1e-12; ///< pieces of less than this part of a wavelength stay whole

struct Node {
    double wavelength_um = 0.0;
    double value = 0.0;
};

class Sampler {
  public:
    Sampler(const std::function<double(double)>& curve, double relativeTolerance, double floor)
        : curve_(curve), relativeTolerance_(relativeTolerance), floor_(floor) {}

    Node nodeAt(double wavelength_um) {
        const Node node{wavelength_um, curve_(wavelength_um)};
        largest_ = std::max(largest_, std::abs(node.value));
        return node;
    }

    /// Adds the nodes of a piece, all but its last.
    void add(const Node& first, const Node& last, int depth = 0) {
        const int parts = depth < deepest ? partsOf(first, last) : 1;
        if (parts == 1) {
            wavelengths_um_.push_back(first.wavelength_um);
            values_.push_back(first.value);
            return;
        }
        Node from = first;
        for (int part = 1; part <= parts; ++part) {
            const Node to = part == parts
                                ? last
                                : nodeAt(std::lerp(first.wavelength_um, last.wavelength_um,
                                                   static_cast<double>(part) / parts));
            add(from, to, depth + 1);
            from = to;
        }
    }

    Spectrum finish(const Node& last) {
        wavelengths_um_.push_back(last.wavelength_um);
        values_.push_back(last.value);
        return {std::move(wavelengths_um_), std::move(values_), Spectrum::Outside::hold, "curve"};
    }

  private:
    int partsOf(const Node& first, const Node& last) {
        if (last.wavelength_um - first.wavelength_um <= narrowest * last.wavelength_um)
            return 1;
        double deviation = 0.0; // in units of what is tolerated
        for (const double t : {0.25, 0.5, 0.75}) {
            const Node node = nodeAt(std::lerp(first.wavelength_um, last.wavelength_um, t));
            const double chord = std::lerp(first.value, last.value, t);
            const double tolerated =
                relativeTolerance_ * std::max(std::abs(node.value), floor_ * largest_);
            if (tolerated > 0.0)
                deviation = std::max(deviation, std::abs(node.value - chord) / tolerated);
        }
        return deviation <= 1.0 ? 1
                                : static_cast<int>(std::clamp(std::ceil(std::sqrt(deviation)), 2.0,
                                                              static_cast<double>(mostParts)));
    }

    const std::function<double(double)>& curve_;
    double relativeTolerance_;
    double floor_;
    double largest_ = 0.0;
    std::vector<double> wavelengths_um_;
    std::vector<double> values_;
};

} // namespace

Spectrum sampledCurve(const std::function<double(double)>& curve, std::span<const double> kinks,
                      double relativeTolerance, double floor) {
    if (kinks.size() < 2)
        throw LogicError("a curve was sampled between fewer than two wavelengths");
    // All kinks first: they tell how large the curve becomes.
    Sampler sampler(curve, relativeTolerance, floor);
    std::vector<Node> nodes;
    for (const double kink_um : kinks)
        nodes.push_back(sampler.nodeAt(kink_um));
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        sampler.add(nodes[i], nodes[i + 1]);
    return sampler.finish(nodes.back());
}

Spectrum sampledPlanck(double temperature_K, const SpectralRange& range, double factor) {
    // The longest wavelength and the peak tell the size of the curve from the start.
    std::vector<double> kinks = {range.min_um, range.max_um};
    const double peak_um = secondRadiationConstant_um_K / (4.965114231744276 * temperature_K);
    if (peak_um > range.min_um && peak_um < range.max_um)
        kinks.insert(kinks.begin() + 1, peak_um);
    return sampledCurve(
        [temperature_K, factor](double wavelength_um) {
            return factor * planckRadiance_W_m2_sr_um(wavelength_um, temperature_K);
        },
        kinks);
}

} // namespace irsg
