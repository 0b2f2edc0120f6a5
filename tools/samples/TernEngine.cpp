// The nozzles of the sample jet and the gas of its engines.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "irsg/gas/PlumeTable.h"
#include "irsg/gas/RoundJet.h"
#include "tools/samples/GasZones.h"
#include "tools/samples/Patch.h"
#include "tools/samples/SampleTern.h"
#include "tools/samples/TernParts.h"

namespace smat::tern {
namespace {

using irsg::Vec3;

constexpr double pi = std::numbers::pi;
constexpr double liner_m = 0.405;    ///< radius of the liner before the throat
constexpr double turbineAt_m = 2.55; ///< before the exit
constexpr double throatAt_m = 0.42;  ///< likewise
constexpr double convergesAt_m = 0.95;

/// The radius of the nozzle inside, by the distance before its exit.
double insideRadius_m(const Nozzle& nozzle, double before_m) {
    const Curve radius{{0.0, nozzle.exit_m},
                       {throatAt_m, nozzle.throat_m},
                       {convergesAt_m, liner_m},
                       {turbineAt_m, liner_m}};
    return radius(before_m);
}

class NozzleMaker {
  public:
    NozzleMaker(FlightWriter& writer, const Nozzle& nozzle, double side)
        : writer_(writer), nozzle_(nozzle), x_(side * engine_m) {}

    void addOutside(const HotParts& hot) {
        // Petals that overlap: their edges stand out a little.
        constexpr int petals = 15;
        const double last_m = nozzle_.exit_m + 0.012;
        const auto shape = [&](double u, double v) {
            const double from = 1.0 - u;
            const double radius_m =
                std::lerp(last_m, nozzleRoot_m, from * (2.0 - from) * (0.45 + 0.55 * from));
            const double edge = std::pow(std::abs(std::cos(0.5 * petals * v)), 14.0);
            const double swell = 1.0 + 0.018 * edge * std::min(1.0, 6.0 * u);
            return at(nozzleAt_m + nozzle_.length_m * u, radius_m * swell, v);
        };
        const double step = 1.0 / static_cast<double>(hot.petals.size());
        addPatch(writer_, shape, edges(0.0, 1.0, 0.5 * step),
                 edges(0.0, 2.0 * pi, 2.0 * pi / (petals * 6)), [&](double u, double) {
                     const auto number = static_cast<std::size_t>(u / step);
                     return &hot.petals[std::min(number, hot.petals.size() - 1)];
                 });
        addPatch(
            writer_,
            [&](double u, double v) {
                return shape(1.0, v) * (1.0 - u) + at(exit(), nozzle_.exit_m, v) * u;
            },
            edges(0.0, 1.0, 1.0), edges(0.0, 2.0 * pi, 2.0 * pi / (petals * 6)), hot.lip);
    }

    /// Petals, liner and what stands at its end, as one sees them from behind.
    void addInside(const HotParts& hot) {
        const std::array<double, 2> marks{throatAt_m, convergesAt_m};
        revolve([](double u) { return u; }, [&](double u) { return insideRadius_m(nozzle_, u); },
                edges(0.0, convergesAt_m, 0.1, marks), hot.inside);
        revolve([](double u) { return u; }, [&](double u) { return insideRadius_m(nozzle_, u); },
                edges(convergesAt_m, turbineAt_m, 0.2), hot.liner);
        revolve([](double) { return turbineAt_m; }, [](double u) { return liner_m * (1.0 - u); },
                edges(0.0, 0.999, 0.2), hot.turbine);
        // The cone behind the turbine.
        revolve([](double u) { return turbineAt_m - 0.01 - 0.75 * u; },
                [](double u) { return 0.19 * std::sqrt(1.0 - u * u); }, edges(0.0, 1.0, 0.1),
                hot.turbine);
        // Rings that hold the flame.
        for (const double ring_m : {0.17, 0.30})
            revolve([](double u) { return 1.75 + 0.03 * std::cos(u); },
                    [&](double u) { return ring_m + 0.018 * std::sin(u); },
                    edges(0.0, 2.0 * pi, pi / 4), hot.flameholder);
    }

  private:
    double exit() const { return nozzleAt_m + nozzle_.length_m; }
    Vec3 at(double station, double radius_m, double v) const {
        return {x_ + radius_m * std::sin(v), nose_m - station, axis_m + radius_m * std::cos(v)};
    }
    /// About the axis; `before` the exit.
    template <typename Before, typename Radius>
    void revolve(Before before, Radius radius, std::span<const double> us,
                 const FlightSurface& of) {
        addPatch(
            writer_, [&](double u, double v) { return at(exit() - before(u), radius(u), v); }, us,
            edges(0.0, 2.0 * pi, 2.0 * pi / 40), of);
    }

    FlightWriter& writer_;
    const Nozzle& nozzle_;
    double x_;
};

/// The gas of two jets beside each other, whose parts of exhaust add up where they meet: the half
/// on starboard, about the axis of its nozzle.
class TwoJets {
  public:
    explicit TwoJets(const irsg::RoundJet& jet)
        : table_(jet.table()), air_K_(jet.air_K), hot_K_(jet.temperature_K) {}

    const irsg::PlumeTable& table() const { return table_; }
    double temperature_K(double x_m, double across_m, double above_m) const {
        const double both = part(x_m, std::hypot(across_m - engine_m, above_m)) +
                            part(x_m, std::hypot(across_m + engine_m, above_m));
        return std::lerp(air_K_, hot_K_, std::min(1.0, both));
    }
    /// The hottest place between both axes, and never on the plane between them.
    double middle_m(double x_m) const {
        constexpr int looks = 60;
        constexpr double least = 0.25;
        double best_m = engine_m, best_K = 0.0;
        for (int i = 0; i <= looks; ++i) {
            const double across_m = engine_m * std::lerp(1.0, least, double(i) / looks);
            if (const double here_K = temperature_K(x_m, across_m, 0.0); here_K > best_K + 1e-6) {
                best_K = here_K;
                best_m = across_m;
            }
        }
        return best_m;
    }
    /// How far from there, in a direction from the top, gas is as hot; 0 where none is. The half
    /// ends `gap_m` before the plane between the jets.
    double reach_m(double x_m, double middle_m, double angle, double from_K, double gap_m) const {
        const double sine = std::sin(angle), cosine = std::cos(angle);
        const auto isHot = [&](double r_m) {
            return temperature_K(x_m, middle_m + r_m * sine, r_m * cosine) >= from_K;
        };
        double in_m = 0.0, out_m = table_.r_m().back();
        if (sine < 0.0)
            out_m = std::min(out_m, (middle_m - gap_m) / -sine);
        if (isHot(out_m))
            return out_m;
        for (int i = 0; i < 50; ++i) {
            const double half_m = 0.5 * (in_m + out_m);
            (isHot(half_m) ? in_m : out_m) = half_m;
        }
        return in_m;
    }

  private:
    double part(double x_m, double r_m) const {
        if (r_m >= table_.r_m().back())
            return 0.0;
        return (table_.at(x_m, r_m).temperature_K - air_K_) / (hot_K_ - air_K_);
    }

    irsg::PlumeTable table_;
    double air_K_, hot_K_;
};

/// A closed surface: rings about an axis along y, whose first and last are filled.
class Rings {
  public:
    Rings(double side, std::size_t around) : side_(side), around_(around) {}

    double angle(std::size_t k) const {
        return side_ * 2.0 * pi * static_cast<double>(k) / static_cast<double>(around_);
    }
    std::size_t around() const { return around_; }
    /// `radii_m` by angle from the top; no place is nearer to the plane of symmetry than `least_m`.
    void add(double station, double middle_m, const std::vector<double>& radii_m,
             double least_m = 0.0) {
        const double wider = widerThanRound(around_);
        middles_.push_back({side_ * middle_m, nose_m - station, axis_m});
        for (std::size_t k = 0; k < around_; ++k) {
            const Vec3 out{side_ * std::sin(angle(k)), 0.0, std::cos(angle(k))};
            FlightVertex& vertex = vertices_.emplace_back(
                FlightVertex{middles_.back() + out * (wider * radii_m[k]), out});
            // Not across the plane between the jets.
            vertex.position.x = side_ * std::max(side_ * vertex.position.x, least_m);
        }
    }
    /// Ends in a point behind the last ring.
    void close(double station, double middle_m) {
        tip_ = Vec3{side_ * middle_m, nose_m - station, axis_m};
    }
    void write(FlightWriter& writer, const FlightSurface& of) const {
        addClosedRings(writer, of, vertices_, around_, {middles_.front(), {0, 1, 0}},
                       {tip_.value_or(middles_.back()), {0, -1, 0}});
    }

  private:
    double side_;
    std::size_t around_;
    std::vector<Vec3> middles_;
    std::vector<FlightVertex> vertices_;
    std::optional<Vec3> tip_;
};

/// Where a zone ends: along the hottest places of the jets no gas is as hot beyond.
double endOf_m(const TwoJets& jets, double from_K) {
    double in_m = 0.0, out_m = jets.table().x_m().back();
    for (int i = 0; i < 50; ++i) {
        const double half_m = 0.5 * (in_m + out_m);
        (jets.temperature_K(half_m, jets.middle_m(half_m), 0.0) >= from_K ? in_m : out_m) = half_m;
    }
    return in_m;
}

/// One zone on one side, `number` from outside: walls of zones within each other lie apart.
void addZone(FlightWriter& writer, const TwoJets& jets, double side, double exit_m, double from_K,
             std::size_t number, const FlightSurface& of) {
    constexpr double apart_m = 0.0015;
    constexpr int count = 34;
    constexpr std::size_t around = 32;
    const double inset_m = apart_m * static_cast<double>(number + 1);
    const double end_m = endOf_m(jets, from_K), last_m = jets.table().x_m().back();
    Rings rings(side, around);
    for (int i = 0; i < count; ++i) {
        // Closer at the nozzle and at the round end.
        const double t = static_cast<double>(i) / count;
        const double x_m = inset_m + (end_m - inset_m) * std::sin(0.5 * pi * std::pow(t, 1.5));
        const double middle_m = jets.middle_m(x_m);
        std::vector<double> radii_m;
        for (std::size_t k = 0; k < around; ++k)
            radii_m.push_back(roundedEnd(x_m / last_m) *
                              (1.0 - apart_m * static_cast<double>(number)) *
                              jets.reach_m(x_m, middle_m, rings.angle(k), from_K, inset_m));
        rings.add(exit_m + x_m, middle_m, radii_m, inset_m);
    }
    rings.close(exit_m + end_m, jets.middle_m(end_m));
    rings.write(writer, of);
}

} // namespace

void addNozzle(FlightWriter& writer, const Nozzle& nozzle, const HotParts& hot, double side) {
    NozzleMaker maker(writer, nozzle, side);
    maker.addOutside(hot);
    maker.addInside(hot);
}

void addPlumes(FlightWriter& writer, const Nozzle& nozzle, bool isReheat) {
    const irsg::RoundJet jet = ternJet(isReheat);
    const double exit_m = nozzleAt_m + nozzle.length_m;
    const TwoJets jets(jet);
    const std::vector<irsg::PlumeZone> zones = irsg::plumeZones(jets.table(), ternZones(isReheat));
    for (const double side : {1.0, -1.0}) {
        for (std::size_t z = 0; z < zones.size(); ++z) {
            const auto index = nozzle.firstGas + static_cast<std::int32_t>(z);
            addZone(writer, jets, side, exit_m, zones[z].from_K, z,
                    {"zone" + std::to_string(z + 1), {index, index}, false, gas});
        }
        // What fills the nozzle, up to the exit.
        constexpr double clear = 0.985, from_m = 0.002;
        Rings rings(side, 32);
        for (const double before_m : {2.45, 1.8, 1.2, 0.95, 0.8, 0.6, 0.42, 0.2, from_m})
            rings.add(
                exit_m - before_m, engine_m,
                std::vector<double>(rings.around(), clear * insideRadius_m(nozzle, before_m)));
        const auto index = nozzle.firstGas + static_cast<std::int32_t>(zones.size());
        rings.write(writer, {"inner", {index, index}, false, gas});
    }
}

} // namespace smat::tern
