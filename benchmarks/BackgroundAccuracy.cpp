// bench_background: the error of the background grid against its rows, on a clear sky of the
// computed atmosphere with the horizon in the middle of the field, as tables of Markdown; and the
// time that each part of a background takes for a frame of 640 x 512.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <vector>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/radiometry/Quadrature.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/background/BackgroundGrid.h"
#include "irsg/render/background/Skybox.h"
#include "irsg/render/background/SunDisc.h"

using namespace irsg;

namespace {

constexpr int rowCounts[] = {4, 8, 16, 32};
constexpr int testedElevations = 160;

Sensor sensorOf(double verticalField_deg) {
    Sensor sensor;
    sensor.width_px = sensor.height_px = 512;
    sensor.horizontalFieldOfView_rad = radians(verticalField_deg);
    return sensor;
}

Viewpoint looking(double elevation_rad, double altitude_m) {
    const Vec3 eye{0, 0, altitude_m};
    return Viewpoint::lookAt(eye, eye + direction(0.0, elevation_rad));
}

/// In-band radiances along elevations, asked for directly.
class Profile {
  public:
    Profile(const AtmosphereSmart& air, const Band& band)
        : air_(air), range_(band.range()), quadrature_(band, {}, 200.0) {}

    double operator()(const LineOfSight& sight) const {
        const Spectrum spectrum = air_.backgroundRadiance(sight, sun_, range_);
        return quadrature_.integrate(quadrature_.sampled(spectrum));
    }

  private:
    const AtmosphereSmart& air_;
    SpectralRange range_;
    SpectralQuadrature quadrature_;
    SunPosition sun_{1.5, 0.8};
};

void printErrors(const AtmosphereSmart& air, const Band& band) {
    std::printf("\n| %s, altitude, field |", band.name().c_str());
    for (const int rows : rowCounts)
        std::printf(" %d rows |", rows);
    std::printf(" as needed (rows) | one line of sight |\n|---|");
    for (std::size_t i = 0; i < std::size(rowCounts) + 2; ++i)
        std::printf("---|");
    std::printf("\n");
    const Profile profile(air, band);
    for (const double altitude_m : {2.0, 1000.0, 3000.0, 10000.0, 18000.0})
        for (const double field_deg : {2.0, 10.0, 40.0}) {
            const double horizon_rad = air.horizonElevation_rad(altitude_m);
            const Sensor sensor = sensorOf(field_deg);
            const Viewpoint view = looking(horizon_rad, altitude_m);
            const FieldRays rays(sensor, view);
            std::vector<Vec3> directions;
            std::vector<double> truths;
            for (int i = 0; i < testedElevations; ++i) {
                const double v = rays.vLimit() * (2.0 * (i + 0.5) / testedElevations - 1.0);
                directions.push_back(normalized(rays.at(0.0, v)));
                truths.push_back(profile({altitude_m, elevationOf_rad(directions.back()), 0.0}));
            }
            const auto worstOf = [&](const std::function<double(const Vec3&)>& background) {
                double worst = 0.0;
                for (std::size_t i = 0; i < truths.size(); ++i)
                    worst = std::max(worst, std::abs(background(directions[i]) / truths[i] - 1.0));
                return 100.0 * worst;
            };
            std::printf("| %g m, %g deg |", altitude_m, field_deg);
            for (const int rows : rowCounts) {
                const BackgroundGrid grid(sensor, view, horizon_rad, rows, 1, profile);
                std::printf(" %.3f %% |", worstOf([&](const Vec3& d) { return grid.at(d); }));
            }
            const BackgroundGrid needed(sensor, view, horizon_rad, BackgroundGrid::asManyAsNeeded,
                                        1, profile);
            std::printf(" %.3f %% (%zu) |", worstOf([&](const Vec3& d) { return needed.at(d); }),
                        needed.elevations_rad().size());
            const double centre = profile({altitude_m, horizon_rad, 0.0});
            std::printf(" %.3g %% |\n", worstOf([&](const Vec3&) { return centre; }));
            std::fflush(stdout);
        }
}

/// Milliseconds of the quickest of several runs.
double quickest_ms(const std::function<void()>& work) {
    double best = 1e9;
    for (int i = 0; i < 9; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double, std::milli> time =
            std::chrono::steady_clock::now() - begin;
        best = std::min(best, time.count());
    }
    return best;
}

void printTimes() {
    Sensor sensor;
    sensor.horizontalFieldOfView_rad = radians(20.0);
    const Viewpoint view = looking(0.02, 1000.0);
    const FieldRays rays(sensor, view);
    std::printf("\n| part, 640 x 512 | ms |\n|---|---|\n");
    for (const int columns : {1, 8}) {
        const BackgroundGrid grid(sensor, view, 0.0, 16, columns, [](const LineOfSight& sight) {
            return 2.0 + sight.elevation_rad;
        });
        std::printf("| grid of 16 x %d | %.1f |\n", columns, quickest_ms([&] { grid.pixels(); }));
    }
    for (const int size : {256, 4096}) {
        std::array<TextureImage, 6> faces;
        for (TextureImage& face : faces)
            face = {size, size,
                    std::vector<float>(
                        static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0.5f)};
        const Skybox sky(std::move(faces));
        std::printf("| skybox of %d texels a side | %.1f |\n", size,
                    quickest_ms([&] { sky.pixels(rays, {}); }));
    }
    std::printf("| disc of the sun | %.2f |\n",
                quickest_ms([&] { SunDisc(rays, Horizon(rays, 0.0), direction(0.0, 0.05)); }));
}

} // namespace

int main() {
    printTimes();
    AtmosphereSmartParameters parameters;
    parameters.irradianceMode = 2; // nothing from tables
    parameters.resolution_per_cm = 15;
    parameters.baseWavelengthMax_um = 12.0;
    const AtmosphereSmart air(parameters);
    for (const Band& band : {Band::topHat(3.0, 5.0), Band::topHat(8.0, 12.0)})
        printErrors(air, band);
    return 0;
}
