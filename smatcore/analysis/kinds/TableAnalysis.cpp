#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "irsg/geometry/view/Vec3.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/settings/SettingRows.h"

namespace smat {

namespace key {
constexpr TextKey tableSampling{"table.sampling"};
constexpr TextKey tableSteps{"table.steps"};
constexpr RealKey tableAzimuthStep{"table.azimuthStep"};
constexpr RealKey tableElevationStep{"table.elevationStep"};
constexpr OptionalRealKey tableElevationFrom{"table.elevationFrom"};
constexpr RealKey tableElevationTo{"table.elevationTo"};
constexpr IntegerKey tableSubdivisions{"table.subdivisions"};
constexpr RealListKey tableRanges{"table.ranges"};
constexpr RealListKey tableTimes{"table.times"};
constexpr RealListKey tablePowers{"table.powers"};
constexpr RealListKey tableMachs{"table.machs"};
constexpr RealListKey tableAltitudes{"table.altitudes"};
constexpr BooleanKey tableSource{"table.source"};
} // namespace key

namespace {

using irsg::Quantity;

std::vector<SettingInfo> tableSettings() {
    using namespace rows;
    const auto list = [](RealListKey key, const char* option, const char* label, const char* unit,
                         double minimum, double maximum, const char* what, const char* setting) {
        return numbers(key, option, label, unit, {"as-set"}, minimum, maximum, "as-set",
                       fmt::format("{} of the table; as-set: the one of {}.", what, setting));
    };
    return {
        named(choice(key::tableSampling, "--sampling", "Sampling of the sphere",
                     {"grid", "icosphere"}, "grid",
                     "Directions from the target to the camera: a grid of azimuths and "
                     "elevations, or the corners of an icosphere, which lie alike everywhere and "
                     "waste none at the poles."),
              {"azimuth × elevation", "icosphere"}),
        adaptiveSteps(key::tableSteps,
                      "of azimuth and elevation of a grid, whole rows and columns, down to 1/16 of "
                      "the step"),
        number(key::tableAzimuthStep, "--azimuth-step", "Azimuth step", "deg", 0.01, 180, "5",
               "Of a grid: angle between two azimuths, from 0 once around."),
        number(key::tableElevationStep, "--elevation-step", "Elevation step", "deg", 0.01, 180, "5",
               "Of a grid: angle between two elevations."),
        choiceOrNumber(
            key::tableElevationFrom, "--elevation-from", "Elevations from", "deg", {"lowest"}, -90,
            90, "lowest",
            "First elevation; of an icosphere the least. lowest: -90, or the first whole "
            "step at which the camera stands above the ground."),
        number(key::tableElevationTo, "--elevation-to", "Elevations to", "deg", -90, 90, "90",
               "Last elevation, which has cases whatever the step; of an icosphere the largest."),
        integer(key::tableSubdivisions, "--subdivisions", "Subdivisions", "", 0, 7, "3",
                "Of an icosphere: 10 × 4ⁿ + 2 corners, 642 for 3, some 8 deg apart."),
        list(key::tableRanges, "--ranges", "Ranges", "m", 0, 1e8, "Ranges", "the camera"),
        list(key::tableTimes, "--times", "Times", "s", -1e9, 1e9, "Times", "the state"),
        list(key::tablePowers, "--powers", "Engine powers", "", 0, 1e6, "Engine powers",
             "the state"),
        list(key::tableMachs, "--machs", "Mach numbers", "", 0, 30, "Mach numbers", "the state"),
        list(key::tableAltitudes, "--altitudes", "Altitudes", "m", 0, 1e6,
             "Altitudes of the target", "the target"),
        flag(key::tableSource, "--source", "Without air, too", true,
             "Adds the intensity of the source: what leaves the target, lit as it is, with no air "
             "between and nothing behind it; spectra that were measured as they were, at their "
             "reference distance."),
    };
}

/// Something that the table varies.
struct Axis {
    Quantity quantity;
    RealListKey list;
    std::string_view setting; ///< it stands in for
};
constexpr std::array axes{Axis{Quantity::range, key::tableRanges, key::cameraRange},
                          Axis{Quantity::time, key::tableTimes, key::stateTime},
                          Axis{Quantity::power, key::tablePowers, key::statePower},
                          Axis{Quantity::mach, key::tableMachs, key::stateMach},
                          Axis{Quantity::altitude, key::tableAltitudes, key::targetAltitude}};

/// The values of an axis, in the order given; those of the setting where there are none.
std::vector<double> valuesOf(const Axis& axis, const Settings& settings) {
    std::vector<double> values = settings[axis.list];
    if (values.empty())
        values.push_back(settings[RealKey{axis.setting.data()}]);
    return values;
}

/// Below it the farthest camera of the lowest target would stand below the ground.
double lowest_deg(const Settings& settings) {
    const double range_m = std::ranges::max(valuesOf(axes[0], settings));
    const double altitude_m = std::ranges::min(valuesOf(axes[4], settings));
    return range_m > altitude_m ? -irsg::degrees(std::asin(altitude_m / range_m)) : -90.0;
}

double from_deg(const Settings& settings) {
    if (const auto given_deg = settings[key::tableElevationFrom])
        return *given_deg;
    const double step_deg = settings[key::tableElevationStep], bound_deg = lowest_deg(settings);
    return bound_deg <= -90.0 ? -90.0 : std::ceil(bound_deg / step_deg) * step_deg + 0.0;
}

struct Direction {
    double azimuth_deg, elevation_deg;
};

/// From one angle to another, the last included.
std::vector<double> anglesBetween_deg(double from_deg, double to_deg, double step_deg) {
    std::vector<double> angles;
    for (std::size_t i = 0; stepped(from_deg, i, step_deg) < to_deg - 1e-9; ++i)
        angles.push_back(stepped(from_deg, i, step_deg));
    angles.push_back(to_deg);
    return angles;
}

std::vector<RefinedAxis> gridAxes(const Settings& settings) {
    const double azimuthStep_deg = settings[key::tableAzimuthStep];
    const double elevationStep_deg = settings[key::tableElevationStep];
    const auto count = static_cast<std::size_t>(
        std::ceil(360.0 / azimuthStep_deg - 1e-9)); // the end is the beginning
    constexpr double least = 1.0 / 16.0;            // of the step
    RefinedAxis azimuth{Quantity::azimuth, {}, true, least * azimuthStep_deg};
    for (std::size_t i = 0; i < count; ++i)
        azimuth.places.push_back(stepped(0.0, i, azimuthStep_deg));
    return {
        azimuth,
        {Quantity::elevation,
         anglesBetween_deg(from_deg(settings), settings[key::tableElevationTo], elevationStep_deg),
         false, least * elevationStep_deg}};
}

std::vector<Direction> grid(const std::vector<RefinedAxis>& axes) {
    std::vector<Direction> directions;
    for (const double elevation_deg : axes[1].places)
        for (const double azimuth_deg : axes[0].places)
            directions.push_back({azimuth_deg, elevation_deg});
    return directions;
}

/// The cases of a table over these directions: outside what moves target or camera; inside what
/// leaves the drawing as it is.
std::vector<AnalysisCase> casesOver(const std::vector<Direction>& directions,
                                    const Settings& settings);

/// The corners of an icosahedron, with the middles of the edges `subdivisions` times over.
std::vector<irsg::Vec3> icosphere(int subdivisions) {
    const double golden = 0.5 * (1.0 + std::sqrt(5.0));
    // A corner at the zenith and one at the nadir would be seen along the axis of the azimuth.
    std::vector<irsg::Vec3> corners;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-golden, golden}) {
            corners.push_back(irsg::normalized(irsg::Vec3{0.0, a, b}));
            corners.push_back(irsg::normalized(irsg::Vec3{a, b, 0.0}));
            corners.push_back(irsg::normalized(irsg::Vec3{b, 0.0, a}));
        }
    // Corners that are neighbours are 2 apart before they are normalized.
    const double edge = 2.0 / std::sqrt(1.0 + golden * golden);
    using Face = std::array<std::size_t, 3>;
    const auto areNeighbours = [&](std::size_t i, std::size_t j) {
        return std::abs(irsg::length(corners[i] - corners[j]) - edge) < 1e-6;
    };
    std::vector<Face> faces;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t j = i + 1; j < corners.size(); ++j)
            for (std::size_t k = j + 1; k < corners.size(); ++k)
                if (areNeighbours(i, j) && areNeighbours(j, k) && areNeighbours(i, k))
                    faces.push_back({i, j, k});
    for (int n = 0; n < subdivisions; ++n) {
        std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
        const auto middle = [&](std::size_t i, std::size_t j) {
            const auto [known, isNew] = middles.try_emplace(std::minmax(i, j), corners.size());
            if (isNew)
                corners.push_back(irsg::normalized(corners[i] + corners[j]));
            return known->second;
        };
        std::vector<Face> finer;
        for (const auto& [i, j, k] : faces) {
            const std::size_t ij = middle(i, j), jk = middle(j, k), ik = middle(i, k);
            finer.insert(finer.end(), {{i, ij, ik}, {j, jk, ij}, {k, ik, jk}, {ij, jk, ik}});
        }
        faces = std::move(finer);
    }
    return corners;
}

std::vector<Direction> icosphere(const Settings& settings) {
    const auto rounded = [](double angle_deg) { return std::round(angle_deg * 1e9) / 1e9 + 0.0; };
    std::vector<Direction> directions;
    for (const irsg::Vec3& corner : icosphere(settings[key::tableSubdivisions])) {
        const double azimuth_deg = rounded(irsg::degrees(std::atan2(corner.x, corner.y)));
        const Direction one{azimuth_deg < 0.0 ? azimuth_deg + 360.0 : azimuth_deg,
                            rounded(irsg::degrees(std::asin(std::clamp(corner.z, -1.0, 1.0))))};
        if (one.elevation_deg >= from_deg(settings) &&
            one.elevation_deg <= settings[key::tableElevationTo])
            directions.push_back(one);
    }
    // Views from one elevation share their air.
    std::ranges::sort(directions, {}, [](const Direction& one) {
        return std::pair{one.elevation_deg, one.azimuth_deg};
    });
    return directions;
}

/// Cameras that would stand below the ground, told of once.
void checkGround(const Settings& settings, const std::vector<Direction>& directions,
                 std::vector<irsg::Diagnostic>& diagnostics) {
    const auto byElevation = [](const Direction& a, const Direction& b) {
        return a.elevation_deg < b.elevation_deg;
    };
    const double least_deg = std::ranges::min_element(directions, byElevation)->elevation_deg;
    if (least_deg < lowest_deg(settings) - 1e-6) {
        const double range_m = std::ranges::max(valuesOf(axes[0], settings));
        const double altitude_m = std::ranges::min(valuesOf(axes[4], settings));
        diagnostics.push_back(
            {.file = "",
             .position = key::tableElevationFrom,
             .value = settings.text(key::tableElevationFrom),
             .expected = fmt::format(
                 "at least {:.6g} deg, or a target higher up: at {:.6g} deg, {:.6g} m from a "
                 "target at {:.6g} m, the camera would be {:.6g} m below the ground",
                 lowest_deg(settings), least_deg, range_m, altitude_m,
                 -altitude_m - range_m * std::sin(irsg::radians(least_deg)))});
    }
}

void planTable(AnalysisPlan& plan, const Project&, const Settings& settings,
               std::vector<irsg::Diagnostic>& diagnostics) {
    plan.coordinate = Quantity::azimuth;
    plan.columns = {Quantity::azimuth, Quantity::elevation, Quantity::range,   Quantity::time,
                    Quantity::power,   Quantity::mach,      Quantity::altitude};
    plan.withSource = settings[key::tableSource];
    const auto refuse = [&](std::string_view key, std::string expected) {
        diagnostics.push_back({.file = "",
                               .position = std::string(key),
                               .value = settings.text(key),
                               .expected = std::move(expected)});
    };
    if (settings[key::tableElevationTo] < from_deg(settings)) {
        refuse(key::tableElevationTo, "an angle not below table.elevationFrom, which is " +
                                          fmt::format("{:.6g} deg", from_deg(settings)));
        return;
    }
    double states = 1.0;
    for (const Axis& axis : axes)
        states *= static_cast<double>(valuesOf(axis, settings).size());
    const bool isGrid = settings.text(key::tableSampling) == "grid";
    const double rows =
        (settings[key::tableElevationTo] - from_deg(settings)) / settings[key::tableElevationStep] +
        1.0;
    const double most = isGrid ? rows * 360.0 / settings[key::tableAzimuthStep]
                               : 10.0 * std::pow(4.0, settings[key::tableSubdivisions]) + 2.0;
    if (most * states > mostCases) {
        refuse(isGrid ? std::string_view(key::tableAzimuthStep)
                      : std::string_view(key::tableSubdivisions),
               fmt::format("at most {:.0f} cases, not {:.0f}", mostCases, most * states));
        return;
    }
    const bool isAdaptive = settings.text(key::tableSteps) == "adaptive";
    if (isAdaptive && !isGrid) {
        refuse(key::tableSteps, "fixed: corners of an icosphere are not refined, only a grid is");
        return;
    }
    const std::vector<RefinedAxis> gridPlaces = gridAxes(settings);
    const std::vector<Direction> directions = isGrid ? grid(gridPlaces) : icosphere(settings);
    if (directions.empty()) {
        refuse(key::tableElevationFrom, "elevations that hold a corner of the icosphere");
        return;
    }
    checkGround(settings, directions, diagnostics);
    if (!diagnostics.empty())
        return;

    plan.axes = {Quantity::azimuth, Quantity::elevation};
    for (const Axis& axis : axes)
        if (valuesOf(axis, settings).size() > 1)
            plan.axes.push_back(axis.quantity);
    plan.isAlongRange = valuesOf(axes[0], settings).size() > 1;
    plan.cases = casesOver(directions, settings);
    if (isAdaptive) {
        plan.refined = gridPlaces;
        plan.casesAt = [settings](const std::vector<RefinedAxis>& places) {
            return casesOver(grid(places), settings);
        };
    }
}

std::vector<AnalysisCase> casesOver(const std::vector<Direction>& directions,
                                    const Settings& settings) {
    std::vector<AnalysisCase> cases;
    for (const double altitude_m : valuesOf(axes[4], settings))
        for (const Direction& from : directions)
            for (const double range_m : valuesOf(axes[0], settings))
                for (const double time_s : valuesOf(axes[1], settings))
                    for (const double power : valuesOf(axes[2], settings))
                        for (const double mach : valuesOf(axes[3], settings)) {
                            AnalysisCase one = startingCase(settings);
                            one.coordinate = from.azimuth_deg;
                            one.azimuth_rad = irsg::radians(from.azimuth_deg);
                            one.elevation_rad = irsg::radians(from.elevation_deg);
                            one.shownAzimuth_deg = from.azimuth_deg;
                            one.shownElevation_deg = from.elevation_deg;
                            one.range_m = range_m;
                            one.time_s = time_s;
                            one.power = power;
                            one.mach = mach;
                            one.altitude_m = altitude_m;
                            cases.push_back(one);
                        }
    return cases;
}

std::vector<std::string> ignoredByTable(const Settings& settings) {
    std::vector<std::string> keys{key::cameraAzimuth, key::cameraElevation};
    for (const Axis& axis : axes)
        if (!settings[axis.list].empty())
            keys.emplace_back(axis.setting);
    return keys;
}

} // namespace

extern constinit const AnalysisDefinition tableAnalysis{
    .name = "table",
    .title = "Signature table",
    .help = "Intensity over azimuth, elevation, range and state",
    .icon = "table",
    .settings = tableSettings,
    .plan = planTable,
    .ignored = ignoredByTable,
    .isOverDirections = true};

} // namespace smat
