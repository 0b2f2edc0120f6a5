// An engine of the sample aircraft: nacelle, intake, propeller, nozzle with an inside, plume.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "irsg/gas/PlumeTable.h"
#include "irsg/gas/RoundJet.h"
#include "tools/samples/GasZones.h"
#include "tools/samples/HeronParts.h"
#include "tools/samples/HeronSurfaces.h"
#include "tools/samples/Patch.h"
#include "tools/samples/SampleHeron.h"

namespace smat::heron {
namespace {

using irsg::Vec3;

constexpr double pi = std::numbers::pi;
/// The front of the nacelle along y, and the height of its axis.
constexpr double front_m = 5.35;
constexpr double axis_m = 1.02;
constexpr double length_m = 6.9;
constexpr double nozzleRadius_m = 0.185, pipeRadius_m = 0.27;
constexpr double nozzleDrop_m = -0.12; ///< of its axis below the nacelle's
constexpr double pipeLength_m = 1.35;

const Curve halfWidth{{0.0, 0.38}, {0.4, 0.47}, {1.3, 0.58}, {2.8, 0.62},
                      {4.6, 0.56}, {6.0, 0.38}, {6.9, 0.225}};
const Curve top{{0.0, 0.38}, {0.4, 0.46}, {1.3, 0.56}, {2.8, 0.66},
                {4.6, 0.60}, {6.0, 0.30}, {6.9, 0.105}};
const Curve bottom{{0.0, -0.38}, {0.4, -0.50}, {1.3, -0.68}, {2.8, -0.80},
                   {4.6, -0.72}, {6.0, -0.50}, {6.9, -0.345}};

/// Where the pipe ends, behind the front.
constexpr double exit_m = length_m + 0.06;
/// The radius of the pipe by the distance before its exit.
double insideRadius_m(double before_m) {
    static const Curve radius{{0.0, nozzleRadius_m}, {0.9, pipeRadius_m}};
    return radius(before_m);
}

/// Where the cowls get warmer in steps, and where they do so again before the nozzle.
constexpr double warmFrom_m = 2.4, warmTo_m = 4.8, hotFrom_m = 5.55, lipFrom_m = 6.45;
const double warmStep_m = (warmTo_m - warmFrom_m) / static_cast<double>(middleCowl.size());
const double hotStep_m = (lipFrom_m - hotFrom_m) / static_cast<double>(endCowl.size());

const FlightSurface* cowlAt(double station) {
    if (station > lipFrom_m)
        return &lip;
    const auto stepOf = [&](double from_m, double step_m) {
        return static_cast<std::size_t>((station - from_m) / step_m);
    };
    if (station > hotFrom_m)
        return &endCowl[std::min(stepOf(hotFrom_m, hotStep_m), endCowl.size() - 1)];
    if (station < warmFrom_m)
        return &cowl;
    const std::size_t step = stepOf(warmFrom_m, warmStep_m);
    return step < middleCowl.size() ? &middleCowl[step] : &rearCowl;
}

class Engine {
  public:
    Engine(FlightWriter& writer, double side) : writer_(writer), x_(side * engine_m) {}

    void add() {
        addNacelle();
        addIntake();
        addPropeller();
        addNozzle();
        addPlume();
    }

  private:
    /// A place by its distance behind the front, and across.
    Vec3 at(double behind, double across, double above) const {
        return {x_ + across, front_m - behind, axis_m + above};
    }
    /// A surface of revolution about an axis `drop` from that of the nacelle, its front outwards
    /// where `behind` grows along it.
    template <typename Behind, typename Radius>
    void revolve(Behind behind, Radius radius, double drop, std::span<const double> us,
                 const FlightSurface& of, int around = 28) {
        addPatch(
            writer_,
            [&](double u, double v) {
                return at(behind(u), radius(u) * std::sin(v), drop + radius(u) * std::cos(v));
            },
            us, edges(0.0, 2.0 * pi, 2.0 * pi / around), of);
    }

    Vec3 nacelle(double station, double angle) const {
        const double middle = 0.5 * (top(station) + bottom(station));
        const double half = 0.5 * (top(station) - bottom(station));
        return at(station, halfWidth(station) * std::sin(angle), middle + half * std::cos(angle));
    }

    void addNacelle() {
        std::vector<double> marks{lipFrom_m};
        for (std::size_t i = 0; i <= middleCowl.size(); ++i)
            marks.push_back(warmFrom_m + warmStep_m * static_cast<double>(i));
        for (std::size_t i = 0; i < endCowl.size(); ++i)
            marks.push_back(hotFrom_m + hotStep_m * static_cast<double>(i));
        addPatch(
            writer_, [&](double u, double v) { return nacelle(u, v); },
            edges(0.0, length_m, 0.3, marks), edges(0.0, 2.0 * pi, 2.0 * pi / 32),
            [](double station, double) { return cowlAt(station); });
        // The wall behind the spinner.
        revolve([](double) { return 0.0; }, [](double u) { return u; }, 0.0,
                edges(0.30, 0.38, 0.04), cowl);
    }

    /// A scoop below the spinner with a lip of bare metal and a duct behind it.
    void addIntake() {
        constexpr double halfWide = 0.30, halfHigh = 0.15, centre = -0.62, depth = 0.9;
        const auto ring = [&](double behind, double size, double v) {
            return at(behind, halfWide * size * std::sin(v),
                      centre + halfHigh * size * std::cos(v));
        };
        const auto around = edges(0.0, 2.0 * pi, 2.0 * pi / 28);
        // Outside it goes back into the nacelle.
        addPatch(
            writer_,
            [&](double u, double v) {
                const double size = 1.15 + 0.25 * std::sin(0.5 * pi * u);
                const Vec3 own = ring(0.05 + 2.0 * u, size, v);
                return own + Vec3{0.0, 0.0, 0.16 * u * u};
            },
            edges(0.0, 1.0, 0.125), around, cowl);
        // The lip: half a turn from the outside to the duct.
        addPatch(
            writer_,
            [&](double u, double v) {
                return ring(0.05 - 0.05 * std::sin(u), 1.075 - 0.075 * std::cos(u), v);
            },
            edges(0.0, pi, pi / 6), around, bareMetal);
        addPatch(
            writer_, [&](double u, double v) { return ring(0.05 + depth * (1.0 - u), 1.0, v); },
            edges(0.0, 1.0, 0.25), around, intake);
        addPatch(
            writer_, [&](double u, double v) { return ring(0.05 + depth, u, v); },
            edges(0.0, 1.0, 0.5), around, intake);
    }

    void addPropeller() {
        constexpr double radius = 0.38, spinnerLength = 0.95, propeller = 1.98;
        revolve([=](double u) { return -spinnerLength * (1.0 - u * u); },
                [=](double u) { return radius * std::pow(u, 0.9); }, 0.0, edges(0.0, 1.0, 0.1),
                spinner);
        revolve([](double) { return -0.22; }, [=](double u) { return u; }, 0.0,
                edges(radius, propeller, 0.4), disc, 48);
    }

    void addNozzle() {
        // Lip, the wall of the pipe that one sees from behind, and the turbine at its end.
        addPatch(
            writer_,
            [&](double u, double v) {
                const Vec3 outer = nacelle(length_m, v);
                const Vec3 inner = at(exit_m, nozzleRadius_m * std::sin(v),
                                      nozzleDrop_m + nozzleRadius_m * std::cos(v));
                return outer * (1.0 - u) + inner * u;
            },
            edges(0.0, 1.0, 0.5), edges(0.0, 2.0 * pi, 2.0 * pi / 32), lip);
        revolve([](double u) { return exit_m - u; }, insideRadius_m, nozzleDrop_m,
                edges(0.0, pipeLength_m, 0.1), pipe, 32);
        revolve([](double) { return exit_m - pipeLength_m; }, [](double u) { return u; },
                nozzleDrop_m, edges(0.0, 0.999 * pipeRadius_m, 0.05), turbine, 32);
        // The cone behind the turbine.
        revolve([](double u) { return exit_m + 0.01 - pipeLength_m + 0.55 * u; },
                [](double u) { return 0.13 * std::sqrt(1.0 - u); }, nozzleDrop_m,
                edges(0.0, 1.0, 0.125), turbine, 24);
    }

    /// Zones of the jet behind the nozzle, and what fills the pipe.
    void addPlume() {
        const PlumeAxis axis = [this](double along_m) {
            return AxisPlace{at(exit_m + along_m, 0.0, nozzleDrop_m), {0.0, -1.0, 0.0}};
        };
        const Vec3 across{1.0, 0.0, 0.0};
        addGasZones(writer_, irsg::plumeZones(heronJet().table(), heronZones), axis, across,
                    firstGas, gas);
        constexpr double clear = 0.985, from_m = 0.002;
        std::vector<std::array<double, 2>> inside_m;
        for (const double before_m : {pipeLength_m - 0.02, 0.9, 0.7, 0.5, 0.3, 0.15, from_m})
            inside_m.push_back({-before_m, clear * insideRadius_m(before_m)});
        constexpr std::int32_t index = firstGas + static_cast<std::int32_t>(heronZones);
        addGasTube(writer_, inside_m, axis, across, {"inner", {index, index}, false, gas});
    }

    FlightWriter& writer_;
    double x_;
};

} // namespace

void addEngine(FlightWriter& writer, double side) {
    Engine(writer, side).add();
}

} // namespace smat::heron
