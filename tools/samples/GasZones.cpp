#include "tools/samples/GasZones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "irsg/core/FileReplacement.h"

namespace smat {
namespace {

using irsg::Vec3;

constexpr double pi = std::numbers::pi;
constexpr std::size_t around = 24;

/// The radius of an outline of (x, r), x ascending.
double radiusAt_m(const std::vector<std::array<double, 2>>& outline, double x_m) {
    const auto above =
        std::ranges::lower_bound(outline.begin() + 1, outline.end() - 1, x_m, {},
                                 [](const std::array<double, 2>& place) { return place[0]; });
    const auto& [x1_m, r1_m] = *above;
    const auto& [x0_m, r0_m] = *(above - 1);
    return x1_m > x0_m ? std::lerp(r0_m, r1_m, (x_m - x0_m) / (x1_m - x0_m)) : r1_m;
}

/// A closed surface of rings about an axis, with a lid before the first and a tip behind the last.
class Tube {
  public:
    explicit Tube(const Vec3& across) : across_(across) {}

    void add(const AxisPlace& axis, double radius_m) {
        const double wide_m = widerThanRound(around) * radius_m;
        const Vec3 out = cross(axis.along, across_);
        Vec3 one = axis.place + out * wide_m, other = axis.place - out * wide_m;
        if (!rings_.empty()) {
            one = before(one, rings_.back().one);
            other = before(other, rings_.back().other);
        }
        rings_.push_back({one, other, wide_m});
        forward_ = normalized(cross(across_, one - other));
    }
    /// Ends in a point behind the last ring.
    void close(const Vec3& tip) { tip_ = tip; }
    /// No place is nearer to the plane x = 0 than `least_m`, on one side of it.
    void write(ModelWriter& writer, const FlightSurface& of, double side, double least_m) const {
        std::vector<FlightVertex> all;
        const auto kept = [&](const Vec3& place) {
            return side == 0.0
                       ? place
                       : Vec3{std::copysign(std::max(std::copysign(1.0, side) * place.x, least_m),
                                            side),
                              place.y, place.z};
        };
        for (const Ring& ring : rings_) {
            const Vec3 middle = (ring.one + ring.other) * 0.5, half = ring.one - middle;
            for (std::size_t k = 0; k < around; ++k) {
                const double angle = 2.0 * pi * static_cast<double>(k) / around;
                const Vec3 out = half * std::cos(angle) + across_ * (ring.wide_m * std::sin(angle));
                all.push_back({kept(middle + out), normalized(out)});
            }
        }
        const Vec3 begins = (rings_.front().one + rings_.front().other) * 0.5;
        addClosedRings(writer, of, std::move(all), around, {begins, normalized(begins - tip_)},
                       {tip_, normalized(tip_ - begins)});
    }

  private:
    struct Ring {
        Vec3 one, other; ///< its ends in the plane of the axis
        double wide_m;   ///< its radius across that plane
    };
    /// A place, or one just before the last ring where it would be behind that.
    Vec3 before(const Vec3& place, const Vec3& last) const {
        constexpr double least_m = 1e-3;
        return dot(place - last, forward_) < least_m ? last + forward_ * least_m : place;
    }

    Vec3 across_, forward_, tip_;
    std::vector<Ring> rings_;
};

/// Distances along an axis, closer at both ends.
std::vector<double> places_m(double first_m, double last_m) {
    constexpr int count = 20;
    std::vector<double> places;
    for (int i = 0; i <= count; ++i) {
        const double t = static_cast<double>(i) / count;
        places.push_back(std::lerp(first_m, last_m, std::sin(0.5 * pi * t * std::sqrt(t))));
    }
    return places;
}

Tube tubeOf(const std::vector<std::array<double, 2>>& outline_m, const PlumeAxis& axis,
            const Vec3& across) {
    Tube tube(across);
    const auto places = places_m(outline_m.front()[0], outline_m.back()[0]);
    for (const double x_m : std::span(places).first(places.size() - 1))
        tube.add(axis(x_m), radiusAt_m(outline_m, x_m));
    tube.close(axis(places.back()).place);
    return tube;
}

} // namespace

void addClosedRings(ModelWriter& writer, const FlightSurface& of, std::vector<FlightVertex> rings,
                    std::size_t around, const FlightVertex& lid, const FlightVertex& tip) {
    const std::size_t last = rings.size() / around - 1;
    const auto lidAt = static_cast<std::uint32_t>(rings.size());
    rings.push_back(lid);
    rings.push_back(tip);
    const auto at = [&](std::size_t ring, std::size_t k) {
        return static_cast<std::uint32_t>(ring * around + k % around);
    };
    FlightPrimitive first{FlightPrimitive::Kind::fan, {lidAt}},
        end{FlightPrimitive::Kind::fan, {lidAt + 1}};
    for (std::size_t k = 0; k <= around; ++k) {
        first.indices.push_back(at(0, k));
        end.indices.push_back(at(last, around - k));
    }
    std::vector<FlightPrimitive> strips{first, end};
    for (std::size_t ring = 0; ring < last; ++ring) {
        FlightPrimitive& strip = strips.emplace_back();
        for (std::size_t k = 0; k <= around; ++k) {
            strip.indices.push_back(at(ring, k));
            strip.indices.push_back(at(ring + 1, k));
        }
    }
    writer.addMesh(of, rings, strips);
}

double widerThanRound(std::size_t corners) {
    const double step = 2.0 * pi / static_cast<double>(corners);
    return std::sqrt(step / std::sin(step));
}

double roundedEnd(double place) {
    constexpr double from = 0.75;
    const double over = std::max(0.0, (place - from) / (1.0 - from));
    return std::sqrt(std::max(0.0, 1.0 - over * over));
}

void addGasTube(ModelWriter& writer, const std::vector<std::array<double, 2>>& outline_m,
                const PlumeAxis& axis, const Vec3& across, const FlightSurface& of) {
    tubeOf(outline_m, axis, across).write(writer, of, 0.0, 0.0);
}

void addGasZones(ModelWriter& writer, const std::vector<irsg::PlumeZone>& zones,
                 const PlumeAxis& axis, const Vec3& across, std::int32_t first, const Look& look,
                 double side) {
    // Walls of zones within each other lie apart.
    constexpr double apart_m = 0.0015, thinner = 0.0015;
    double end_m = 0.0;
    for (const irsg::PlumeZone& zone : zones)
        for (const auto& outline : zone.outlines_m)
            end_m = std::max(end_m, outline.back()[0]);
    for (std::size_t z = 0; z < zones.size(); ++z)
        for (const auto& outline : zones[z].outlines_m) {
            const auto number = static_cast<double>(z);
            const bool isCutOff = outline.back()[1] > 0.0;
            std::vector<std::array<double, 2>> own;
            for (const double x_m : places_m(outline.front()[0] + apart_m * (number + 1.0),
                                             outline.back()[0] - apart_m * number))
                own.push_back({x_m, radiusAt_m(outline, x_m) * (1.0 - thinner * number) *
                                        (isCutOff ? roundedEnd(x_m / end_m) : 1.0)});
            const std::int32_t index = first + static_cast<std::int32_t>(z);
            const FlightSurface of{"zone" + std::to_string(z + 1), {index, index}, false, look};
            tubeOf(own, axis, across).write(writer, of, side, apart_m * (number + 1.0));
        }
}

void savePlumeTable(const irsg::PlumeTable& table, const std::filesystem::path& file) {
    std::string text = "x [m],r [m],T [K],CO2,H2O,O2\n";
    for (std::size_t x = 0; x < table.x_m().size(); ++x)
        for (std::size_t r = 0; r < table.r_m().size(); ++r) {
            const irsg::GasLayer& gas = table.node(x, r);
            text += fmt::format("{:.5g},{:.5g},{:.6g},{:.5g},{:.5g},{:.5g}\n", table.x_m()[x],
                                table.r_m()[r], gas.temperature_K, gas.fraction(irsg::HotGas::CO2),
                                gas.fraction(irsg::HotGas::H2O), gas.oxygenFraction);
        }
    irsg::writeFileDurably(file, text);
}

} // namespace smat
