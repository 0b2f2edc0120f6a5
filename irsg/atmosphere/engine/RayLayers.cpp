#include "irsg/atmosphere/engine/RayLayers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace irsg {

namespace {

/// Of the earth's curvature: the most by which a layer may bend a ray.
constexpr double greatestBending = 0.8;

/// Enough points for 1e-10 of a layer in which the refractivity falls by exp(-fall).
const GaussRule& ruleFor(double fall) {
    return gaussLegendre(fall < 0.4 ? 3 : fall < 2.0 ? 6 : 16);
}

/// exp(x) - 1; by its series, which is all of double precision, where |x| < 0.25.
double smallExpm1(double x) {
    if (std::abs(x) >= 0.25)
        return std::expm1(x);
    double sum = 1.0 / 479001600.0;
    for (const double term :
         {1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0, 1.0 / 40320.0, 1.0 / 5040.0,
          1.0 / 720.0, 1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0})
        sum = sum * x + term;
    return sum * x;
}

} // namespace

RayLayers::RayLayers(std::vector<double> altitudes_m, std::vector<double> refractivity,
                     double earthRadius_m)
    : altitudes_m_(std::move(altitudes_m)),
      earthRadius_m_(earthRadius_m),
      layers_(altitudes_m_.size()) {
    layers_.back().refractivity = std::max(refractivity.back(), 1e-30);
    layers_.back().rule = &ruleFor(0.0);
    for (int k = top() - 1; k >= 0; --k) {
        const auto i = static_cast<std::size_t>(k);
        Layer& layer = layers_[i];
        const double above = layers_[i + 1].refractivity;
        const double greatest = greatestBending * thickness_m(k) / radius_m(k);
        const double step = std::clamp(refractivity[i] - refractivity[i + 1], -greatest, greatest);
        layer.refractivity = std::max(above + step, 1e-30);
        const double fall = std::log(layer.refractivity / above);
        layer.perHeight_per_m = fall / thickness_m(k);
        layer.rule = &ruleFor(std::abs(fall));
    }
    groundW_m_ = (1.0 + layers_[0].refractivity) * earthRadius_m_;
    for (int k = 0; k < top(); ++k) {
        const auto i = static_cast<std::size_t>(k);
        layers_[i + 1].w_m = layers_[i].w_m + rise_m(radius_m(k), layers_[i].refractivity,
                                                     layers_[i].perHeight_per_m, thickness_m(k));
    }
}

double RayLayers::rise_m(double radius_m, double refractivity, double perHeight_per_m,
                         double rise_m) const {
    const double change = std::expm1(-perHeight_per_m * rise_m);
    return rise_m + refractivity * (rise_m * (1.0 + change) + radius_m * change);
}

RayLayers::Place RayLayers::place(double altitude_m) const {
    const auto above = std::ranges::upper_bound(altitudes_m_, altitude_m);
    const int layer = std::max(0, static_cast<int>(above - altitudes_m_.begin()) - 1);
    const Layer& in = layers_[static_cast<std::size_t>(layer)];
    const double height_m = altitude_m - base_m(layer);
    return {layer, height_m,
            in.w_m + rise_m(radius_m(layer), in.refractivity, in.perHeight_per_m, height_m)};
}

double RayLayers::index(const Place& place) const {
    const Layer& layer = layers_[static_cast<std::size_t>(place.layer)];
    return 1.0 + layer.refractivity * std::exp(-layer.perHeight_per_m * place.height_m);
}

double RayLayers::difference_m(const Place& low, const Place& high) const {
    if (low.layer != high.layer)
        return high.w_m - low.w_m;
    const Layer& layer = layers_[static_cast<std::size_t>(low.layer)];
    return rise_m(radius_m(low.layer) + low.height_m, index(low) - 1.0, layer.perHeight_per_m,
                  high.height_m - low.height_m);
}

RayLayers::Place RayLayers::below(const Place& from, double fall_m, double& depth_m) const {
    const double w_m = from.w_m - fall_m;
    int k = from.layer;
    while (k > 0 && from.w_m - layers_[static_cast<std::size_t>(k)].w_m < fall_m)
        --k;
    const Layer& layer = layers_[static_cast<std::size_t>(k)];

    // Newton downwards from the start, or from the layer's ceiling if the start is above it.
    const bool isSame = k == from.layer;
    const double start_m = isSame ? from.height_m : thickness_m(k);
    const Layer& next = layers_[static_cast<std::size_t>(std::min(k + 1, top()))];
    const double wanted_m = isSame ? fall_m : fall_m - (from.w_m - next.w_m);
    const double radius = radius_m(k) + start_m;
    const double refractivity = layer.refractivity * std::exp(-layer.perHeight_per_m * start_m);
    double down_m = 0.0;
    for (int pass = 0; pass < 20; ++pass) {
        const double n = refractivity * std::exp(layer.perHeight_per_m * down_m);
        const double slope = 1.0 + n - (radius - down_m) * n * layer.perHeight_per_m;
        const double error_m =
            wanted_m + rise_m(radius, refractivity, layer.perHeight_per_m, -down_m);
        down_m += error_m / slope;
        if (std::abs(error_m) <= 1e-14 * wanted_m)
            break;
    }
    const double height_m = std::max(0.0, start_m - down_m);
    depth_m = isSame ? down_m : from.height_m + base_m(from.layer) - base_m(k + 1) + down_m;
    return {k, height_m, w_m};
}

RayLayers::Measures RayLayers::measureStraight(const Rise& rise, double invariant_m) const {
    const double n = 1.0 + layers_.back().refractivity;
    const double highU_m = rise.lowU_m + n * rise.height_m;
    const double low = std::sqrt(rise.lowU_m * (rise.lowU_m + 2.0 * invariant_m));
    const double high = std::sqrt(highU_m * (highU_m + 2.0 * invariant_m));
    const double sumOfW = rise.lowU_m + highU_m + 2.0 * invariant_m;
    Measures result;
    result.length_m = rise.height_m * sumOfW / (low + high);
    result.meanHeight_m = rise.lowHeight_m + 0.5 * rise.height_m;
    result.angle_rad = std::atan2(high, invariant_m) - std::atan2(low, invariant_m);
    return result;
}

/// A piece in the variable p: with z = c p (2 q + p), q = sqrt(u) at the low end and c the inverse
/// slope of w there, u is nearly (q + p)^2, and the root in ds = w dz / sqrt(u (u + 2 C)) cancels,
/// at a tangent (q = 0) too.
struct RayLayers::Stretch {
    double radius_m, refractivity, perHeight_per_m, lowU_m, invariant_m;
    double c, q, last;

    Stretch(const RayLayers& layers, const Rise& rise, double invariant)
        : lowU_m(rise.lowU_m), invariant_m(invariant) {
        const Layer& layer = layers.layers_[static_cast<std::size_t>(rise.layer)];
        radius_m = layers.radius_m(rise.layer) + rise.lowHeight_m;
        perHeight_per_m = layer.perHeight_per_m;
        refractivity = layer.refractivity * std::exp(-perHeight_per_m * rise.lowHeight_m);
        c = 1.0 / (1.0 + refractivity - radius_m * refractivity * perHeight_per_m);
        q = std::sqrt(lowU_m);
        last = rise.height_m / c / (q + std::sqrt(lowU_m + rise.height_m / c));
    }

    struct Point {
        double height_m, w_m, root_m;
    };
    Point at(double p) const {
        const double z = c * p * (2.0 * q + p);
        const double change = smallExpm1(-perHeight_per_m * z);
        const double n = 1.0 + refractivity * (1.0 + change);
        const double u = lowU_m + z * n + refractivity * radius_m * change;
        return {z, n * (radius_m + z), std::sqrt(u * (u + 2.0 * invariant_m))};
    }
};

RayLayers::Measures RayLayers::measure(const Rise& rise, double invariant_m) const {
    if (rise.layer == top())
        return measureStraight(rise, invariant_m);
    const Stretch stretch(*this, rise, invariant_m);
    const GaussRule& rule = *layers_[static_cast<std::size_t>(rise.layer)].rule;
    Measures sum;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double p = stretch.last * rule.nodes[i];
        const Stretch::Point point = stretch.at(p);
        const double perRoot = rule.weights[i] * (stretch.q + p) / point.root_m;
        const double length = perRoot * point.w_m;
        sum.length_m += length;
        sum.meanHeight_m += length * point.height_m;
        sum.angle_rad += perRoot / (stretch.radius_m + point.height_m);
    }
    const double scale = 2.0 * stretch.c * stretch.last;
    sum.meanHeight_m = rise.lowHeight_m + sum.meanHeight_m / sum.length_m;
    sum.length_m *= scale;
    sum.angle_rad *= scale * invariant_m;
    return sum;
}

double RayLayers::sineInMiddle(const Rise& rise, double invariant_m) const {
    const Stretch stretch(*this, rise, invariant_m);
    const Stretch::Point middle = stretch.at(0.5 * stretch.last);
    return std::min(1.0, middle.root_m / middle.w_m);
}

} // namespace irsg
