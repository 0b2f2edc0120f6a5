// The body of the sample jet: nose, canopy, intakes, bays of the engines.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tools/samples/Patch.h"
#include "tools/samples/TernParts.h"

namespace smat::tern {
namespace {

using irsg::Vec3;

constexpr double pi = std::numbers::pi;
constexpr double length_m = 14.7;
constexpr double radomeTo_m = 1.5;

/// The middle of the body, over the root of the station, so that the nose is round.
const Curve halfWidth{{0.0, 0.0},     {0.548, 0.135}, {0.894, 0.27}, {1.265, 0.41}, {1.612, 0.52},
                      {1.897, 0.585}, {2.191, 0.63},  {2.449, 0.66}, {2.828, 0.66}, {3.162, 0.58},
                      {3.464, 0.43},  {3.674, 0.28},  {3.8341, 0.10}};
const Curve top{{0.0, 0.0},    {0.548, 0.10}, {0.894, 0.205}, {1.265, 0.33}, {1.612, 0.45},
                {1.897, 0.56}, {2.191, 0.69}, {2.449, 0.78},  {2.828, 0.80}, {3.162, 0.68},
                {3.464, 0.46}, {3.674, 0.29}, {3.8341, 0.11}};
const Curve bottom{{0.0, -0.0},    {0.548, -0.14}, {0.894, -0.26}, {1.265, -0.39}, {1.612, -0.49},
                   {1.897, -0.55}, {2.191, -0.59}, {2.449, -0.61}, {2.828, -0.61}, {3.162, -0.53},
                   {3.464, -0.39}, {3.674, -0.25}, {3.8341, -0.08}};

/// An engine's duct and bay over the station: a box with round corners becomes a circle.
struct Bay {
    double axis_m, height_m, halfWide_m, halfHigh_m, exponent;
};
Bay bayAt(double station) {
    static const Curve axis{
        {5.3, 1.0}, {7.5, 0.94}, {10.0, 0.80}, {12.0, engine_m}, {14.2, engine_m}};
    static const Curve height{
        {5.3, -0.12}, {7.5, -0.07}, {10.0, -0.02}, {12.0, axis_m}, {14.2, axis_m}};
    static const Curve wide{
        {5.3, 0.33}, {7.5, 0.44}, {10.0, 0.51}, {12.0, 0.50}, {14.2, nozzleRoot_m}};
    static const Curve high{
        {5.3, 0.46}, {7.5, 0.50}, {10.0, 0.52}, {12.0, 0.50}, {14.2, nozzleRoot_m}};
    static const Curve corners{{5.3, 5.0}, {7.5, 3.4}, {10.0, 2.4}, {12.0, 2.0}, {14.2, 2.0}};
    return {axis(station), height(station), wide(station), high(station), corners(station)};
}

double outOf(double across, double above, double exponent) {
    return std::pow(std::pow(std::abs(across), exponent) + std::pow(std::abs(above), exponent),
                    1.0 / exponent) -
           1.0;
}

/// Below 0 in the body, whose middle and bays run into each other. Before the intakes and behind
/// the wing the bays are thinner than themselves: there they have surfaces of their own.
double outside(double station, double x_m, double z_m) {
    static const Curve thickness{{5.3, 0.5},   {6.2, 0.90},  {7.2, 1.0}, {10.9, 1.0},
                                 {12.0, 0.96}, {12.8, 0.80}, {13.8, 0.4}};
    constexpr double sharpness = 9.0;
    const double t = std::sqrt(std::max(station, 1e-6));
    const double wide = std::max(halfWidth(t), 1e-4),
                 high = std::max(0.5 * (top(t) - bottom(t)), 1e-4);
    double sum =
        std::exp(-sharpness * outOf(x_m / wide, (z_m - 0.5 * (top(t) + bottom(t))) / high, 2.25));
    if (station > 5.3 && station < 13.8) {
        const Bay bay = bayAt(station);
        const double part = thickness(station);
        for (const double side : {1.0, -1.0})
            sum += std::exp(-sharpness * outOf((x_m - side * bay.axis_m) / (part * bay.halfWide_m),
                                               (z_m - bay.height_m) / (part * bay.halfHigh_m),
                                               bay.exponent));
    }
    return -std::log(std::max(sum, 1e-300)) / sharpness;
}

/// `angle` from the top towards starboard, radians.
Vec3 body(double station, double angle) {
    const double t = std::sqrt(std::max(station, 0.0));
    const double middle = 0.5 * (top(t) + bottom(t));
    const double sine = std::sin(angle), cosine = std::cos(angle);
    // From outside inwards, since bays hide what lies nearer.
    constexpr double most_m = 1.9, step_m = 0.05;
    double out_m = most_m, in_m = most_m;
    const auto isOut = [&](double r_m) {
        return outside(station, r_m * sine, middle + r_m * cosine) > 0.0;
    };
    while (in_m > 0.0 && isOut(in_m)) {
        out_m = in_m;
        in_m -= step_m;
    }
    in_m = std::max(in_m, 0.0);
    for (int i = 0; i < 40; ++i) {
        const double half_m = 0.5 * (in_m + out_m);
        (isOut(half_m) ? out_m : in_m) = half_m;
    }
    const double r_m = station <= 0.0 ? 0.0 : in_m;
    return {r_m * sine, nose_m - station, middle + r_m * cosine};
}

/// Where the upper side becomes the lower one, in steps.
constexpr double flankFrom_deg = 94.0, flankStep_deg = 5.0;

const FlightSurface* bodySurface(double station, double angle) {
    const double fromTop = std::abs(std::remainder(angle, 2.0 * pi)) * 180.0 / pi;
    if (station < radomeTo_m)
        return &radome;
    if (fromTop < flankFrom_deg)
        return &skin;
    const auto step = static_cast<std::size_t>((fromTop - flankFrom_deg) / flankStep_deg);
    return step < flank.size() ? &flank[step] : &belly;
}

void addHull(FlightWriter& writer) {
    std::vector<double> around;
    for (std::size_t i = 0; i <= flank.size(); ++i) {
        const double angle = (flankFrom_deg + flankStep_deg * static_cast<double>(i)) * pi / 180.0;
        around.insert(around.end(), {angle, 2.0 * pi - angle});
    }
    std::vector<double> us;
    for (const double t : edges(0.0, std::sqrt(radomeTo_m), 0.1))
        us.push_back(t * t);
    const auto rest = edges(radomeTo_m, length_m, 0.2);
    us.insert(us.end(), rest.begin() + 1, rest.end());
    const auto vs = edges(0.0, 2.0 * pi, 2.0 * pi / 88, around);
    addPatch(writer, body, us, vs, bodySurface);
    const Vec3 end = body(length_m, 0.0) * 0.5 + body(length_m, pi) * 0.5;
    addPatch(
        writer, [&](double u, double v) { return body(length_m, v) * (1.0 - u) + end * u; },
        edges(0.0, 1.0, 1.0), vs, tail);
}

/// A bubble of one piece behind a windscreen, between frames.
void addCanopy(FlightWriter& writer) {
    constexpr double from_m = 2.25, to_m = 6.0;
    static const Curve ridge{{2.25, 0.44}, {2.6, 0.66}, {3.0, 0.89}, {3.5, 1.07},
                             {4.1, 1.13},  {4.7, 1.09}, {5.3, 0.97}, {6.0, 0.79}};
    static const Curve wide{{2.25, 0.20}, {2.6, 0.33}, {3.0, 0.40}, {3.5, 0.44},
                            {4.4, 0.45},  {5.2, 0.40}, {6.0, 0.30}};
    static const Curve sill{{2.25, 0.30}, {3.0, 0.36}, {4.0, 0.44}, {5.2, 0.52}, {6.0, 0.56}};
    const auto shape = [](double station, double v) {
        const double across = std::copysign(std::pow(std::abs(std::cos(v)), 0.9), std::cos(v));
        return Vec3{-wide(station) * across, nose_m - station,
                    sill(station) + (ridge(station) - sill(station)) * std::pow(std::sin(v), 0.9)};
    };
    const std::array<double, 6> marks{2.32, 3.02, 3.12, 5.02, 5.14, 5.4};
    const auto surfaceAt = [](double station, double) {
        const bool isFrame = station < 2.32 || (station > 3.02 && station < 3.12) ||
                             (station > 5.02 && station < 5.14);
        return isFrame ? &frame : station > 5.14 ? &skin : &canopy;
    };
    addPatch(writer, shape, edges(from_m, to_m, 0.1, marks), edges(0.001, pi - 0.001, pi / 36),
             surfaceAt);
}

/// A bay with its intake, on one side.
class Engine {
  public:
    Engine(FlightWriter& writer, double side) : writer_(writer), side_(side) {}

    void addIntake() {
        const auto around = edges(0.0, 2.0 * pi, 2.0 * pi / 44);
        // Outside it goes into the body.
        add(
            [&](double u, double v) {
                const double station = std::lerp(lipAt(v), 8.0, u);
                return at(station, v, 1.0 - 0.035 * u * u, station);
            },
            edges(0.0, 1.0, 0.1), around, &skin);
        // The lip: half a turn from the outside to the duct.
        add(
            [&](double u, double v) {
                return at(lipAt(v) - 0.04 * std::sin(u), v, 0.965 - 0.035 * std::cos(u), lipAt(v));
            },
            edges(0.0, pi, pi / 6), around, &edge);
        // The duct becomes a circle before the engine.
        constexpr double end_m = 9.4, radius_m = 0.40;
        add(
            [&](double u, double v) {
                const double station = std::lerp(end_m, lipAt(v), u);
                const Vec3 front = at(station, v, 0.93, lipAt(v));
                const Vec3 back = onFace(end_m, radius_m, v);
                const double part = (1.0 - u) * (1.0 - u) * (1.0 + 2.0 * u);
                return Vec3{std::lerp(front.x, back.x, part), nose_m - station,
                            std::lerp(front.z, back.z, part)};
            },
            edges(0.0, 1.0, 0.05), around, &duct);
        add([&](double u, double v) { return onFace(end_m, radius_m * u, v); },
            edges(0.0, 1.0, 0.25), around, &face);
        add([&](double u, double v) { return onFace(end_m - 0.3 * (1.0 - u * u), 0.13 * u, v); },
            edges(0.0, 1.0, 0.125), around, &face);
    }

    /// From under the wing to the nozzle, warmer towards it.
    void addBay(const HotParts& hot) {
        constexpr double from_m = 10.4, warmFrom_m = 11.7;
        const double step_m = (nozzleAt_m - warmFrom_m) / static_cast<double>(hot.bays.size());
        std::vector<double> marks;
        for (std::size_t i = 0; i < hot.bays.size(); ++i)
            marks.push_back(warmFrom_m + step_m * static_cast<double>(i));
        addPatch(
            writer_,
            [&](double station, double v) {
                const double thin = std::max(0.0, (11.6 - station) / (11.6 - from_m));
                return at(station, v, 1.0 - 0.03 * thin, station);
            },
            edges(from_m, nozzleAt_m, 0.2, marks), edges(0.0, 2.0 * pi, 2.0 * pi / 48),
            [&](double station, double v) {
                if (station < warmFrom_m)
                    return std::cos(v) > 0.0 ? &skin : &belly;
                const auto step = static_cast<std::size_t>((station - warmFrom_m) / step_m);
                return &hot.bays[std::min(step, hot.bays.size() - 1)];
            });
    }

  private:
    /// A place on the section that a bay has at `of`, put to a station; `v` from the top.
    Vec3 at(double station, double v, double size, double of) const {
        const Bay bay = bayAt(of);
        const auto squarer = [&](double s) {
            return std::copysign(std::pow(std::abs(s), 2.0 / bay.exponent), s);
        };
        return {side_ * bay.axis_m + size * bay.halfWide_m * squarer(std::sin(v)), nose_m - station,
                bay.height_m + size * bay.halfHigh_m * squarer(std::cos(v))};
    }
    /// The upper edge stands before the lower one.
    static double lipAt(double v) { return 5.3 + 0.28 * (1.0 - std::cos(v)); }
    Vec3 onFace(double station, double radius_m, double v) const {
        return {side_ * 0.82 + radius_m * std::sin(v), nose_m - station,
                -0.03 + radius_m * std::cos(v)};
    }
    void add(const Shape& shape, std::span<const double> us, std::span<const double> vs,
             const FlightSurface* of) {
        addPatch(writer_, shape, us, vs, *of);
    }

    FlightWriter& writer_;
    double side_;
};

} // namespace

void addBody(FlightWriter& writer, const HotParts& hot) {
    addHull(writer);
    addCanopy(writer);
    for (const double side : {1.0, -1.0}) {
        Engine engine(writer, side);
        engine.addIntake();
        engine.addBay(hot);
    }
    // The probe before the nose, and a hook below the tail.
    addEllipsoid(writer, {0.0, nose_m + 0.25, 0.0}, {0.022, 0.5, 0.022}, frame, 12, 10);
    addEllipsoid(writer, {0.0, nose_m - 14.1, -0.16}, {0.06, 1.0, 0.06}, tail, 14, 12);
}

} // namespace smat::tern
