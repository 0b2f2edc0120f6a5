// An engine of the sample aircraft: nacelle, intake, propeller, nozzle with an inside, plume.
#include <array>
#include <cmath>
#include <numbers>

#include "apps/samples/HeronParts.h"
#include "apps/samples/HeronSurfaces.h"
#include "apps/samples/Patch.h"

namespace smat::heron {
namespace {

using irsg::Vec3;

constexpr double pi = std::numbers::pi;
/// The front of the nacelle along y, and the height of its axis.
constexpr double front_m = 5.35;
constexpr double axis_m = 1.02;
constexpr double length_m = 6.9;
constexpr double nozzleRadius_m = 0.29;
constexpr double nozzleDrop_m = -0.12; ///< of its axis below the nacelle's
constexpr double pipeLength_m = 1.35;

const Curve halfWidth{{0.0, 0.38}, {0.4, 0.47}, {1.3, 0.58}, {2.8, 0.62},
                      {4.6, 0.56}, {6.0, 0.41}, {6.9, 0.335}};
const Curve top{{0.0, 0.38}, {0.4, 0.46}, {1.3, 0.56}, {2.8, 0.66},
                {4.6, 0.60}, {6.0, 0.34}, {6.9, 0.215}};
const Curve bottom{{0.0, -0.38}, {0.4, -0.50}, {1.3, -0.68}, {2.8, -0.80},
                   {4.6, -0.72}, {6.0, -0.54}, {6.9, -0.455}};

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
        const std::array marks{4.0, 6.45};
        addPatch(
            writer_, [&](double u, double v) { return nacelle(u, v); },
            edges(0.0, length_m, 0.3, marks), edges(0.0, 2.0 * pi, 2.0 * pi / 32),
            [](double station, double) {
                return station < 4.0 ? &cowl : station < 6.45 ? &rearCowl : &lip;
            });
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
        const auto inwards = edges(0.0, 1.0, 0.125);
        // Lip, the wall of the pipe that one sees from behind, and the turbine at its end.
        addPatch(
            writer_,
            [&](double u, double v) {
                const Vec3 outer = nacelle(length_m, v);
                const Vec3 inner = at(length_m + 0.06, nozzleRadius_m * std::sin(v),
                                      nozzleDrop_m + nozzleRadius_m * std::cos(v));
                return outer * (1.0 - u) + inner * u;
            },
            edges(0.0, 1.0, 0.5), edges(0.0, 2.0 * pi, 2.0 * pi / 32), lip);
        revolve([](double u) { return length_m + 0.06 - pipeLength_m * u; },
                [](double u) { return nozzleRadius_m * (1.0 - 0.06 * u); }, nozzleDrop_m, inwards,
                pipe, 32);
        revolve([](double) { return length_m + 0.06 - pipeLength_m; }, [](double u) { return u; },
                nozzleDrop_m, edges(0.0, 0.95 * nozzleRadius_m, 0.05), turbine, 32);
        // The cone behind the turbine.
        revolve([](double u) { return length_m + 0.07 - pipeLength_m + 0.55 * u; },
                [](double u) { return 0.13 * std::sqrt(1.0 - u); }, nozzleDrop_m,
                edges(0.0, 1.0, 0.125), turbine, 24);
    }

    /// A shell closed but for its end in the nozzle.
    void addShell(double length, double widest, const FlightSurface& of) {
        const Curve radius{{0.0, nozzleRadius_m * 0.98},
                           {0.06, nozzleRadius_m + 0.2 * (widest - nozzleRadius_m)},
                           {0.45, widest},
                           {0.75, 0.86 * widest},
                           {1.0, 0.0}};
        // Rounded where it ends.
        const auto along = [](double u) { return std::sin(0.5 * pi * u); };
        revolve([=](double u) { return length_m + 0.08 + length * along(u); },
                [=](double u) {
                    const double t = along(u);
                    return t < 0.75
                               ? radius(t)
                               : radius(0.75) * std::sqrt(std::max(
                                                    0.0, 1.0 - (t - 0.75) * (t - 0.75) / 0.0625));
                },
                nozzleDrop_m, edges(0.0, 1.0, 1.0 / 18), of, 24);
    }
    void addPlume() {
        addShell(3.2, 0.31, plumeCore);
        addShell(6.5, 0.50, plumeMiddle);
        addShell(10.5, 0.80, plumeOuter);
    }

    FlightWriter& writer_;
    double x_;
};

} // namespace

void addEngine(FlightWriter& writer, double side) {
    Engine(writer, side).add();
}

} // namespace smat::heron
