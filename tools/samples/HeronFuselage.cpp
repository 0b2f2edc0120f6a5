// The body of the sample aircraft.
#include <array>
#include <cmath>
#include <numbers>

#include "tools/samples/HeronParts.h"
#include "tools/samples/HeronSurfaces.h"
#include "tools/samples/Patch.h"

namespace smat::heron {
namespace {

using irsg::Vec3;

constexpr double pi = std::numbers::pi;
constexpr double length_m = 24.0;

/// Over the root of the station, so that the nose is round.
const Curve halfWidth{{0.0, 0.0},   {0.55, 0.44}, {1.0, 0.80},  {1.41, 1.08},
                      {1.79, 1.27}, {2.12, 1.36}, {2.45, 1.38}, {4.0, 1.38},
                      {4.36, 1.16}, {4.69, 0.66}, {4.9, 0.21}};
const Curve top{{0.0, -0.38}, {0.55, 0.02}, {1.0, 0.30},  {1.41, 0.56}, {1.79, 1.12},
                {2.12, 1.36}, {2.45, 1.40}, {4.36, 1.40}, {4.69, 1.36}, {4.9, 1.30}};
const Curve bottom{{0.0, -0.38},  {0.55, -0.74}, {1.0, -1.02},  {1.41, -1.21},
                   {1.79, -1.34}, {2.45, -1.40}, {3.74, -1.40}, {4.0, -1.24},
                   {4.36, -0.58}, {4.69, 0.40},  {4.9, 0.90}};

double power(double base, double exponent) {
    return std::copysign(std::pow(std::abs(base), exponent), base);
}

/// `angle` from the top towards starboard, radians.
Vec3 body(double station, double angle) {
    const double t = std::sqrt(std::max(station, 0.0));
    const double middle = 0.5 * (top(t) + bottom(t)), half = 0.5 * (top(t) - bottom(t));
    constexpr double roundness = 2.0 / 2.2;
    return {halfWidth(t) * power(std::sin(angle), roundness), nose_m - station,
            middle + half * power(std::cos(angle), roundness)};
}

double degreesFromTop(double angle) {
    return std::abs(std::remainder(angle, 2.0 * pi)) * 180.0 / pi;
}

struct Pane {
    double first, last; ///< stations
    double from, to;    ///< degrees from the top
};
constexpr std::array<Pane, 3> panes{
    {{2.12, 3.05, 2.0, 30.0}, {2.30, 3.25, 33.0, 57.0}, {3.02, 3.72, 60.0, 76.0}}};
constexpr double firstWindow = 5.2, windowPitch = 0.92, windowLength = 0.36;
constexpr int windows = 12;
constexpr Pane windowRow{0.0, 0.0, 63.0, 77.0};

/// Where the upper side becomes the lower one, in steps.
constexpr double flankFrom_deg = 100.0, flankStep_deg = 6.0;

bool isPane(double station, double fromTop) {
    for (const Pane& each : panes)
        if (station > each.first && station < each.last && fromTop > each.from && fromTop < each.to)
            return true;
    return false;
}

bool isWindow(double station, double fromTop) {
    const double place = (station - firstWindow) / windowPitch;
    const int number = static_cast<int>(std::floor(place));
    return number >= 0 && number < windows && (place - number) * windowPitch < windowLength &&
           number != 3 && fromTop > windowRow.from && fromTop < windowRow.to;
}

const FlightSurface* bodySurface(double station, double angle) {
    const double fromTop = degreesFromTop(angle);
    if (isPane(station, fromTop))
        return &pane;
    if (isWindow(station, fromTop))
        return &window;
    if (station < 0.95)
        return &radome;
    if (fromTop < flankFrom_deg)
        return &skin;
    const auto step = static_cast<std::size_t>((fromTop - flankFrom_deg) / flankStep_deg);
    return step < flank.size() ? &flank[step] : &belly;
}

void addBody(FlightWriter& writer) {
    std::vector<double> stations{0.95}, angles;
    for (const Pane& each : panes) {
        stations.insert(stations.end(), {each.first, each.last});
        angles.insert(angles.end(), {each.from, each.to});
    }
    for (int i = 0; i < windows; ++i) {
        const double first = firstWindow + windowPitch * i;
        stations.insert(stations.end(), {first, first + windowLength});
    }
    angles.insert(angles.end(), {windowRow.from, windowRow.to});
    for (std::size_t i = 0; i <= flank.size(); ++i)
        angles.push_back(flankFrom_deg + flankStep_deg * static_cast<double>(i));
    std::vector<double> around;
    for (const double degrees : angles) {
        const double angle = degrees * pi / 180.0;
        around.insert(around.end(), {angle, 2.0 * pi - angle});
    }
    // The nose needs more of them.
    std::vector<double> us;
    for (const double t : edges(0.0, std::sqrt(0.95), 0.09))
        us.push_back(t * t);
    const auto rest = edges(0.95, length_m, 0.5, stations);
    us.insert(us.end(), rest.begin() + 1, rest.end());
    addPatch(writer, body, us, edges(0.0, 2.0 * pi, 2.0 * pi / 44, around), bodySurface);
}

/// A blade of an antenna on the top or below the belly.
void addBlade(FlightWriter& writer, double station, double base, double height) {
    const double y = nose_m - station;
    for (const double side : {1.0, -1.0}) {
        const auto shape = [=](double u, double v) {
            const double chord = 0.34 - 0.16 * u;
            const double thickness = 0.022 * std::sin(pi * v);
            return Vec3{side * thickness, y - 0.12 * u - chord * v, base + height * u};
        };
        const auto us = edges(0.0, 1.0, 0.5), vs = edges(0.0, 1.0, 0.125);
        if ((side > 0.0) != (height > 0.0))
            addPatch(
                writer, [=](double u, double v) { return shape(v, u); }, vs, us, skin);
        else
            addPatch(writer, shape, us, vs, skin);
    }
}

/// The end of the body: the pipe of the auxiliary power unit, open to behind.
void addTailPipe(FlightWriter& writer) {
    const double y = nose_m - length_m;
    const Vec3 ring = body(length_m, 0.0);
    const double middle = 0.5 * (ring.z + body(length_m, pi).z);
    const auto around = edges(0.0, 2.0 * pi, 2.0 * pi / 24);
    const auto rim = [=](double u, double v) {
        const Vec3 outer = body(length_m, v);
        const Vec3 inner{0.11 * std::sin(v), y, middle + 0.11 * std::cos(v)};
        return outer * (1.0 - u) + inner * u;
    };
    addPatch(writer, rim, edges(0.0, 1.0, 0.5), around, tail);
    const auto inside = [=](double u, double v) {
        return Vec3{0.11 * std::sin(v), y + 0.5 * u, middle + 0.11 * std::cos(v)};
    };
    addPatch(writer, inside, edges(0.0, 1.0, 0.5), around, cove);
    const auto end = [=](double u, double v) {
        return Vec3{0.11 * u * std::sin(v), y + 0.5, middle + 0.11 * u * std::cos(v)};
    };
    addPatch(writer, end, edges(0.0, 1.0, 1.0), around, cove);
}

} // namespace

void addFuselage(FlightWriter& writer) {
    addBody(writer);
    addTailPipe(writer);
    // Wing to body, wheels, search radar below, and the ball of the sight under the nose.
    addEllipsoid(writer, {0.0, 1.0, 1.30}, {1.02, 3.3, 0.50}, skin, 18, 36);
    for (const double side : {1.0, -1.0})
        addEllipsoid(writer, {1.22 * side, 0.1, -1.02}, {0.52, 2.5, 0.50}, belly, 16, 32);
    addEllipsoid(writer, {0.0, 3.6, -1.36}, {0.78, 1.0, 0.55}, radome, 14, 28);
    addEllipsoid(writer, {0.0, 9.35, -1.36}, {0.27, 0.27, 0.27}, turret, 12, 24);
    addBlade(writer, 6.3, 1.36, 0.36);
    addBlade(writer, 14.2, 1.36, 0.30);
    addBlade(writer, 11.4, -1.36, -0.28);
}

} // namespace smat::heron
