// Faces that lie in the plane of another face, as OpenFlight's subfaces do.
#include <cmath>

#include <gtest/gtest.h>

#include "irsg/radiometry/Planck.h"
#include "tests/support/FlightBytes.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

/// A square of 3 m in the xy plane, code 1, with a square of 1 m as its subface in the middle, code
/// 2, and in its middle a subface of 0.5 m, code 3.
std::string stackedSquares() {
    SquareFile file;
    file.size = 3.0;
    file.material = 1;
    file.remake();
    const auto base = file.face;
    file.vertices.clear();
    const auto add = [&](double from, double to) {
        for (const auto& [x, y] : {std::pair{from, from}, {to, from}, {to, to}, {from, to}}) {
            file.vertices +=
                record(flight::vertexCN, i16(0) + i16(0x2000) + f64(x) + f64(y) + f64(0) + f32(0) +
                                             f32(0) + f32(1) + i32(-1) + i32(-1) + i32(0));
        }
    };
    add(-1.5, 1.5);
    add(-0.5, 0.5);
    add(-0.25, 0.25);
    file.palette = record(flight::vertexPalette, i32(8 + 12 * 56));
    const auto subface = [&](int code) {
        SquareFile other;
        other.temperature = code;
        other.material = 1;
        other.remake();
        const int first = 8 + (code - 1) * 4 * 56;
        return other.face + file.pushFace +
               record(flight::vertexList,
                      i32(first) + i32(first + 56) + i32(first + 112) + i32(first + 168)) +
               record(flight::popLevel);
    };
    const auto down = record(flight::pushSubface), up = record(flight::popSubface);
    file.popFace += down + subface(2) + down + subface(3) + up + up;
    return file.bytes();
}

} // namespace

TEST(Subfaces, HideTheFaceTheyLieOnFromAnyDirectionAndRange) {
    const TemporaryFolder folder;
    const auto model = Model::load(folder.write("stack.flt", stackedSquares()));
    auto database = greyDatabase(1.0, 300.0);
    database.temperatures[2] = fixedTemperature(500.0);
    database.temperatures[3] = fixedTemperature(900.0);
    const auto band = Band::topHat(3.0, 5.0);
    const double l1 = bandRadiance_W_m2_sr(band, 300.0), l2 = bandRadiance_W_m2_sr(band, 500.0),
                 l3 = bandRadiance_W_m2_sr(band, 900.0);
    const double radianceTimesArea = 8.0 * l1 + 0.75 * l2 + 0.25 * l3;

    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    RenderSettings settings = RenderSettings::direct();
    settings.tileSide_samples = 0;
    settings.samplesPerAxis = 4;
    irsg.scene.settings = settings;
    irsg.scene.entities = {entityOf(model, database)};
    for (const double range_m : {20.0, 1000.0, 50000.0}) {
        for (const double elevation_deg : {90.0, 50.0, 8.0}) {
            for (const double azimuth_deg : {0.0, 33.0}) {
                look(irsg, {.range_m = range_m,
                            .azimuth_rad = azimuth_deg * 0.0174533,
                            .elevation_rad = elevation_deg * 0.0174533,
                            .width_px = 256,
                            .height_px = 256,
                            .fieldOfView_rad = 5.0 / range_m});
                // Against the intensity of a small flat body: what a sampled edge leaves is per
                // cents of the small square, what a torn surface does is tens.
                const double expected = radianceTimesArea * std::sin(elevation_deg * 0.0174533);
                EXPECT_NEAR(irsg.measure().all.intensity_W_sr / expected, 1.0, 0.03)
                    << range_m << " m, " << elevation_deg << " deg, " << azimuth_deg << " deg";
            }
        }
    }
}
