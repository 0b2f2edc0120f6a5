#include "irsg/atmosphere/engine/RayPath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "irsg/atmosphere/path/SunDiscGeometry.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr double deepestChord_m = 500.0;

using Place = RayLayers::Place;
using Rise = RayLayers::Rise;

double uOf(double w_m, double elevation_rad) {
    const double half = std::sin(0.5 * elevation_rad);
    return 2.0 * w_m * half * half;
}

/// 0 to pi/2.
double elevationOf(double w_m, double u_m) {
    return 2.0 * std::asin(std::min(1.0, std::sqrt(std::max(0.0, u_m) / (2.0 * w_m))));
}

std::vector<double> refractivityOf(const Profile& profile, const std::vector<double>& altitudes_m) {
    std::vector<double> refractivity;
    for (const double altitude_m : altitudes_m) {
        const AtmosphericState air = profile.at(altitude_m);
        const double vapour_hPa = air.fraction(Gas::H2O) * air.pressure_hPa;
        const double dry_hPa = air.pressure_hPa - vapour_hPa;
        refractivity.push_back(2.7272e-4 * (dry_hPa / 1013.25) * (288.15 / air.temperature_K) +
                               3.019e-6 * (vapour_hPa / 13.33) * (293.15 / air.temperature_K));
    }
    return refractivity;
}

std::vector<double> checkedGrid(std::vector<double> altitudes_m, const Profile& profile) {
    if (altitudes_m.size() < 2 || altitudes_m.front() != 0.0 ||
        std::ranges::adjacent_find(altitudes_m, std::greater_equal<>()) != altitudes_m.end() ||
        !(altitudes_m.back() <= profile.top_m()))
        throw LogicError("The grid of a ray tracer ascends from 0 to at most the profile's top");
    return altitudes_m;
}

void require(bool isTrue, const char* position, double value, std::string expected) {
    if (!isTrue)
        throw InputError(Diagnostic{"path", position, numberText(value), std::move(expected)});
}

void requireAltitude(double altitude_m, const char* position) {
    require(std::isfinite(altitude_m) && altitude_m >= 0.0, position, altitude_m,
            "an altitude of at least 0 m");
}

/// Adds segments to a path from the sensor outward.
class Builder {
  public:
    Builder(const RayLayers& layers, double invariant_m)
        : layers_(layers), invariant_m_(invariant_m) {
        path_.segments.reserve(2 * static_cast<std::size_t>(layers.top()) + 2);
    }

    void up(const Place& low, const Place& high, double height_m, double lowU_m) {
        layers_.climb(low, high, height_m, lowU_m, [&](const Rise& rise) { add(rise); });
    }
    void down(const Place& high, const Place& low, double height_m, double lowU_m) {
        const auto first = static_cast<std::ptrdiff_t>(path_.segments.size());
        up(low, high, height_m, lowU_m);
        turn(path_.segments.begin() + first);
    }
    void alongGround(double length_m) {
        if (length_m > 0.0)
            path_.segments.push_back({0, length_m, 0.0, 0.0, 0.0, 0.0});
    }
    /// Looks from the other end.
    void turnAll() { turn(path_.segments.begin()); }

    RayPath finish(RayPath::End end, double endElevation_rad, double tangentAltitude_m) {
        for (const RaySegment& segment : path_.segments)
            path_.length_m += segment.length_m;
        path_.end = end;
        path_.endElevation_rad = endElevation_rad;
        path_.tangentAltitude_m = tangentAltitude_m;
        return std::move(path_);
    }

  private:
    void add(const Rise& rise) {
        if (rise.layer == layers_.top())
            return;
        const RayLayers::Measures measures = layers_.measure(rise, invariant_m_);
        if (!(measures.length_m > 0.0))
            return;
        const double low_m = layers_.base_m(rise.layer) + rise.lowHeight_m;
        const double fraction = measures.meanHeight_m / layers_.thickness_m(rise.layer);
        path_.segments.push_back({rise.layer, measures.length_m, low_m, low_m + rise.height_m,
                                  std::clamp(fraction, 0.0, 1.0),
                                  layers_.sineInMiddle(rise, invariant_m_)});
    }
    void turn(std::vector<RaySegment>::iterator first) {
        std::reverse(first, path_.segments.end());
        for (; first != path_.segments.end(); ++first) {
            std::swap(first->startAltitude_m, first->endAltitude_m);
            first->sinElevation = -first->sinElevation;
        }
    }

    const RayLayers& layers_;
    double invariant_m_;
    RayPath path_;
};

/// Finds where a rising function is 0, from two guesses inside a bracket that may be open above
/// (infinity): secant steps, and halves of the bracket where those leave it. Stops at `tolerance`
/// of the function, or where rounding lets it come no closer.
template <typename Function>
double rootOfRising(Function&& f, double guess, double low, double high, double tolerance) {
    double previous = guess;
    double previousValue = f(guess);
    double best = guess;
    double bestValue = std::abs(previousValue);
    double x = guess - previousValue;
    (previousValue < 0.0 ? low : high) = guess;
    for (int pass = 0; pass < 100 && bestValue > tolerance; ++pass) {
        if (!(x > low && x < high))
            x = std::isinf(high) ? 2.0 * low - std::min(previousValue, -tolerance)
                                 : low + 0.5 * (high - low);
        if (x <= low || x >= high)
            break;
        const double value = f(x);
        if (std::abs(value) < bestValue) {
            best = x;
            bestValue = std::abs(value);
        } else if (bestValue < 100.0 * tolerance) {
            break;
        }
        (value < 0.0 ? low : high) = x;
        const double slope = (value - previousValue) / (x - previous);
        previous = x;
        previousValue = value;
        x = x - value / slope;
    }
    return best;
}

} // namespace

/// The two ends of a finite path, ordered by altitude.
struct RayTracer::Chord {
    Place low;
    Place high;
    double lowRadius_m;
    double rise_m;

    /// Sine of the elevation at the low end of the straight line of that length, without air.
    double sine(double length_m) const {
        return (rise_m * (2.0 * lowRadius_m + rise_m) - length_m * length_m) /
               (2.0 * lowRadius_m * length_m);
    }
    /// Its length, from the elevation.
    double length_m(double elevation_rad) const {
        const double along_m = lowRadius_m * std::sin(elevation_rad);
        const double power = rise_m * (2.0 * lowRadius_m + rise_m);
        const double root = std::sqrt(along_m * along_m + power);
        return along_m > 0.0 ? power / (along_m + root) : root - along_m;
    }
    /// How far below the low end the straight line dips, 0 if it rises from there.
    double dip_m(double length_m) const {
        const double s = std::min(0.0, sine(length_m));
        return s < -1.0 ? lowRadius_m : lowRadius_m * s * s / (1.0 + std::sqrt(1.0 - s * s));
    }
};

RayTracer::RayTracer(const Profile& profile, std::vector<double> gridAltitudes_m,
                     double earthRadius_m)
    : altitudes_m_(checkedGrid(std::move(gridAltitudes_m), profile)),
      earthRadius_m_(earthRadius_m),
      layers_(altitudes_m_, refractivityOf(profile, altitudes_m_), earthRadius_m) {}

double RayTracer::refractiveIndex(double altitude_m) const {
    return layers_.index(layers_.place(std::max(0.0, altitude_m)));
}

double RayTracer::groundElevation(const Place& place) const {
    return -elevationOf(layers_.w_m(place), layers_.difference_m(layers_.place(0.0), place));
}

double RayTracer::lengthOf(const Chord& chord, double elevation_rad) const {
    const double w_m = layers_.w_m(chord.low);
    const double u_m = uOf(w_m, elevation_rad);
    const double invariant_m = w_m * std::cos(elevation_rad);
    double length_m = 0.0;
    const auto sum = [&](const Rise& rise) {
        length_m += layers_.measure(rise, invariant_m).length_m;
    };
    if (elevation_rad < 0.0) {
        double depth_m = 0.0;
        const Place tangent = layers_.below(chord.low, u_m, depth_m);
        layers_.climb(tangent, chord.low, depth_m, 0.0, sum);
        length_m *= 2.0;
    }
    layers_.climb(chord.low, chord.high, chord.rise_m, u_m, sum);
    return length_m;
}

/// The unknown is the length of the straight line with the same elevation: the length of the
/// refracted ray is nearly proportional to it, from the vertical to the tangent.
double RayTracer::elevationOver(const Chord& chord, double range_m, double& length_m) const {
    const auto elevationFor = [&](double straight_m) {
        return std::asin(std::clamp(chord.sine(straight_m), -1.0, 1.0));
    };
    const double ground_rad = groundElevation(chord.low);
    double longest_m = std::numeric_limits<double>::infinity();
    if (elevationFor(2.0 * range_m) <= ground_rad) {
        longest_m = chord.length_m(ground_rad);
        length_m = lengthOf(chord, ground_rad);
        if (length_m <= range_m)
            return ground_rad;
    }
    const double straight_m =
        rootOfRising([&](double x) { return lengthOf(chord, elevationFor(x)) - range_m; },
                     std::min(range_m, longest_m), chord.rise_m, longest_m, 1e-14 * range_m);
    length_m = range_m;
    return std::max(ground_rad, elevationFor(straight_m));
}

RayTracer::Chord RayTracer::chordOf(const AtmosphericPath& path) const {
    const double low_m = std::min(path.sensorAltitude_m, path.targetAltitude_m);
    const double high_m = std::max(path.sensorAltitude_m, path.targetAltitude_m);
    return {layers_.place(low_m), layers_.place(high_m), earthRadius_m_ + low_m,
            std::abs(path.targetAltitude_m - path.sensorAltitude_m)};
}

double RayTracer::elevationAtLow(const Chord& chord, double range_m, double& length_m) const {
    if (range_m > chord.rise_m)
        return elevationOver(chord, range_m, length_m);
    return chord.rise_m == 0.0 ? 0.0 : 0.5 * pi;
}

double RayTracer::hiddenBelow_m(double sensorAltitude_m, double range_m) const {
    const Place ground = layers_.place(0.0);
    const auto lengthTo_m = [&](double altitude_m) {
        double length_m = 0.0;
        layers_.climb(ground, layers_.place(altitude_m), altitude_m, 0.0, [&](const Rise& rise) {
            length_m += layers_.measure(rise, layers_.groundW_m()).length_m;
        });
        return length_m;
    };
    const double behind_m = range_m - lengthTo_m(sensorAltitude_m);
    if (!(behind_m > 0.0))
        return 0.0;
    // By the length of the straight line that touches the ground, as in `elevationOver`.
    const auto altitudeAt_m = [&](double straight_m) {
        return straight_m *
               (straight_m / (earthRadius_m_ + std::hypot(earthRadius_m_, straight_m)));
    };
    return altitudeAt_m(rootOfRising(
        [&](double straight_m) { return lengthTo_m(altitudeAt_m(straight_m)) - behind_m; },
        behind_m, 0.0, std::numeric_limits<double>::infinity(), 1e-13 * range_m));
}

TargetView RayTracer::targetView(const AtmosphericPath& path) const {
    requireAltitude(path.sensorAltitude_m, "sensor altitude");
    requireAltitude(path.targetAltitude_m, "target altitude");
    const double hidden_m = hiddenBelow_m(path.sensorAltitude_m, path.range_m);
    if (hidden_m > 0.0 && path.targetAltitude_m <= hidden_m)
        return {horizonElevation_rad(path.sensorAltitude_m), hidden_m};
    const Chord chord = chordOf(path);
    double length_m = path.range_m;
    const double low_rad = elevationAtLow(chord, path.range_m, length_m);
    if (path.targetAltitude_m >= path.sensorAltitude_m)
        return {low_rad, hidden_m};
    const double highU_m =
        uOf(layers_.w_m(chord.low), low_rad) + layers_.difference_m(chord.low, chord.high);
    return {-elevationOf(layers_.w_m(chord.high), highU_m), hidden_m};
}

RayPath RayTracer::between(const AtmosphericPath& path) const {
    requireAltitude(path.sensorAltitude_m, "sensor altitude");
    requireAltitude(path.targetAltitude_m, "target altitude");
    const double rise_m = std::abs(path.targetAltitude_m - path.sensorAltitude_m);
    require(std::isfinite(path.range_m) && path.range_m >= 0.0, "range", path.range_m,
            "at least 0 m");
    require(path.range_m >= rise_m * (1.0 - 1e-6), "range", path.range_m,
            "at least the difference of the altitudes, " + numberText(rise_m) + " m");

    const double low_m = std::min(path.sensorAltitude_m, path.targetAltitude_m);
    const Chord chord = chordOf(path);
    if (path.range_m > rise_m)
        require(chord.dip_m(path.range_m) - low_m <= deepestChord_m, "range", path.range_m,
                "a target that the earth does not hide: the straight line passes " +
                    numberText(std::round(chord.dip_m(path.range_m) - low_m)) +
                    " m below ground, at most 500 m are allowed");
    double rayLength_m = path.range_m;
    const double elevation_rad = elevationAtLow(chord, path.range_m, rayLength_m);

    const double lowW_m = layers_.w_m(chord.low);
    const double u_m = uOf(lowW_m, elevation_rad);
    Builder builder(layers_, lowW_m * std::cos(elevation_rad));
    double tangent_m = low_m;
    if (elevation_rad < 0.0 || rayLength_m < path.range_m) {
        double depth_m = 0.0;
        const Place tangent = layers_.below(chord.low, u_m, depth_m);
        tangent_m = layers_.altitude_m(tangent);
        builder.down(chord.low, tangent, depth_m, 0.0);
        if (rayLength_m < path.range_m) {
            builder.alongGround(path.range_m - rayLength_m);
            tangent_m = 0.0;
        }
        builder.up(tangent, chord.low, depth_m, 0.0);
    }
    builder.up(chord.low, chord.high, rise_m, u_m);
    if (path.targetAltitude_m < path.sensorAltitude_m) {
        builder.turnAll();
        return builder.finish(RayPath::End::target, -elevation_rad, tangent_m);
    }
    const double highU_m = u_m + layers_.difference_m(chord.low, chord.high);
    return builder.finish(RayPath::End::target, elevationOf(layers_.w_m(chord.high), highU_m),
                          tangent_m);
}

RayPath RayTracer::along(const LineOfSight& sight) const {
    requireAltitude(sight.sensorAltitude_m, "sensor altitude");
    const double elevation_rad = sight.elevation_rad;
    require(std::abs(elevation_rad) <= 0.5 * pi + 1e-12, "elevation", elevation_rad,
            "-pi/2 to pi/2");

    const Place sensor = layers_.place(sight.sensorAltitude_m);
    const Place ground = layers_.place(0.0);
    const Place top = layers_.place(altitudes_m_.back());
    const double w_m = layers_.w_m(sensor);
    const double u_m = uOf(w_m, elevation_rad);
    Builder builder(layers_, std::max(0.0, w_m * std::cos(elevation_rad)));
    if (elevation_rad >= 0.0) {
        if (sensor.layer == top.layer)
            return builder.finish(RayPath::End::space, elevation_rad, sight.sensorAltitude_m);
        builder.up(sensor, top, altitudes_m_.back() - sight.sensorAltitude_m, u_m);
        const double topU_m = u_m + layers_.difference_m(sensor, top);
        return builder.finish(RayPath::End::space, elevationOf(layers_.w_m(top), topU_m),
                              sight.sensorAltitude_m);
    }

    const double fall_m = layers_.difference_m(ground, sensor);
    if (u_m >= fall_m) {
        builder.down(sensor, ground, sight.sensorAltitude_m, u_m - fall_m);
        return builder.finish(RayPath::End::ground,
                              sight.sensorAltitude_m > 0.0
                                  ? -elevationOf(layers_.groundW_m(), u_m - fall_m)
                                  : elevation_rad,
                              0.0);
    }
    double depth_m = 0.0;
    const Place tangent = layers_.below(sensor, u_m, depth_m);
    const double tangent_m = layers_.altitude_m(tangent);
    if (tangent.layer == top.layer)
        return builder.finish(RayPath::End::space, -elevation_rad, tangent_m);
    builder.down(sensor, tangent, depth_m, 0.0);
    builder.up(tangent, top, altitudes_m_.back() - tangent_m, 0.0);
    return builder.finish(RayPath::End::space,
                          elevationOf(layers_.w_m(top), layers_.difference_m(tangent, top)),
                          tangent_m);
}

double RayTracer::trueElevation(double altitude_m, double apparent_rad) const {
    const Place sensor = layers_.place(altitude_m);
    const Place top = layers_.place(altitudes_m_.back());
    const double w_m = layers_.w_m(sensor);
    const double u_m = uOf(w_m, apparent_rad);
    const double invariant_m = w_m * std::cos(apparent_rad);
    double angle_rad = 0.0;
    const auto sum = [&](const Rise& rise) {
        angle_rad += layers_.measure(rise, invariant_m).angle_rad;
    };
    double topU_m = 0.0;
    if (apparent_rad >= 0.0) {
        if (sensor.layer == top.layer)
            return apparent_rad;
        layers_.climb(sensor, top, altitudes_m_.back() - altitude_m, u_m, sum);
        topU_m = u_m + layers_.difference_m(sensor, top);
    } else {
        double depth_m = 0.0;
        const Place tangent = layers_.below(sensor, u_m, depth_m);
        if (tangent.layer == top.layer)
            return apparent_rad;
        layers_.climb(tangent, sensor, depth_m, 0.0, sum);
        layers_.climb(tangent, top, altitudes_m_.back() - layers_.altitude_m(tangent), 0.0, sum);
        topU_m = layers_.difference_m(tangent, top);
    }
    return elevationOf(layers_.w_m(top), topU_m) - angle_rad;
}

double RayTracer::horizonElevation_rad(double altitude_m) const {
    requireAltitude(altitude_m, "altitude");
    return groundElevation(layers_.place(altitude_m));
}

double RayTracer::trueHorizonElevation_rad(double altitude_m) const {
    return trueElevation(altitude_m, horizonElevation_rad(altitude_m));
}

std::optional<double> RayTracer::apparentOf(double altitude_m, double trueElevation_rad) const {
    requireAltitude(altitude_m, "altitude");
    require(std::abs(trueElevation_rad) <= 0.5 * pi + 1e-12, "elevation of the sun",
            trueElevation_rad, "-pi/2 to pi/2");
    const double wanted_rad = std::clamp(trueElevation_rad, -0.5 * pi, 0.5 * pi);
    const double lowest_rad = groundElevation(layers_.place(altitude_m));
    const double highest_rad = std::min(0.5 * pi, std::max(wanted_rad, lowest_rad) + 0.1);
    const auto excess = [&](double apparent_rad) {
        return trueElevation(altitude_m, apparent_rad) - wanted_rad;
    };
    if (wanted_rad < lowest_rad + 0.1 && excess(lowest_rad) > 0.0)
        return std::nullopt;
    const double guess = std::max(wanted_rad, lowest_rad);
    return wanted_rad >= 0.5 * pi ? 0.5 * pi
                                  : rootOfRising(excess, guess, lowest_rad, highest_rad, 1e-13);
}

double RayTracer::apparentElevation_rad(double altitude_m, double trueElevation_rad) const {
    if (const auto apparent_rad = apparentOf(altitude_m, trueElevation_rad))
        return *apparent_rad;
    return horizonElevation_rad(altitude_m) + trueElevation_rad -
           trueHorizonElevation_rad(altitude_m);
}

RayPath RayTracer::towardsSun(double altitude_m, double trueElevation_rad) const {
    if (const auto apparent_rad = apparentOf(altitude_m, trueElevation_rad)) {
        RayPath path = along({altitude_m, *apparent_rad, 0.0});
        if (path.end == RayPath::End::space)
            return path;
    }
    RayPath hidden;
    hidden.end = RayPath::End::ground;
    hidden.endElevation_rad = trueElevation_rad;
    return hidden;
}

RayTracer::Sunbeam RayTracer::sunbeam(double altitude_m, double trueElevation_rad) const {
    // So far above the grazing ray that rounding does not let it meet the ground.
    constexpr double margin_rad = 1e-9;
    const double horizon_rad = trueHorizonElevation_rad(altitude_m);
    const VisibleSun sun = visibleSun(trueElevation_rad - horizon_rad);
    const double middle_rad =
        std::max(trueElevation_rad + sun.middleAbove_rad, horizon_rad + margin_rad);
    return {sun.part, towardsSun(altitude_m, std::min(middle_rad, 0.5 * pi))};
}

} // namespace irsg
