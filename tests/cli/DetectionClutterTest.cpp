// The clutter of backgrounds that are rendered, against direct sums.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/Environment.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/view/Pose.h"
#include "irsg/image/Canvas.h"
#include "irsg/sensor/PointSpread.h"
#include "irsg/sensor/SensorNumbers.h"
#include "irsg/sensor/SensorTransfer.h"
#include "tests/cli/SensorFiles.h"

namespace smat::test {

namespace {

using testing::HasSubstr;

/// What a direct sum of a scene over the pixels of a square finds: the light of samples falls on
/// pixels by the energy of a point there.
class DirectClutter {
  public:
    DirectClutter(const irsg::SensorDescription& sensor, int side, int samples)
        : side_(side), samples_(samples), reach_(4), angle_rad_(sensor.pixelAngle_rad()) {
        const irsg::PointSpread spread(sensor, 300.0);
        const int cells = 2 * reach_ * samples;
        for (int i = 0; i < cells; ++i) {
            for (int j = 0; j < cells; ++j) {
                energies_.push_back(spread.energyAt(offset(i), offset(j)));
            }
        }
        const double sum = std::accumulate(energies_.begin(), energies_.end(), 0.0);
        for (double& energy : energies_) {
            energy /= sum;
        }
    }

    /// `radiance` of tangents to the right and up of the axis.
    double deviation(const std::function<double(double right, double up)>& radiance) const {
        const int edge = reach_ + 1, all = (side_ + 2 * edge) * samples_;
        std::vector<double> field;
        for (int y = 0; y < all; ++y) {
            for (int x = 0; x < all; ++x) {
                field.push_back(radiance(tangent(x, edge), -tangent(y, edge)));
            }
        }
        std::vector<double> pixels;
        const int wide = side_ + 2;
        for (int y = 0; y < wide; ++y) {
            for (int x = 0; x < wide; ++x) {
                // The first cell of those about this pixel's centre.
                const int top = (y + edge - 1) * samples_ + samples_ / 2 - reach_ * samples_;
                const int left = (x + edge - 1) * samples_ + samples_ / 2 - reach_ * samples_;
                double sum = 0.0;
                for (int i = 0; i < 2 * reach_ * samples_; ++i) {
                    for (int j = 0; j < 2 * reach_ * samples_; ++j) {
                        sum += energies_[static_cast<std::size_t>(i * 2 * reach_ * samples_ + j)] *
                               field[static_cast<std::size_t>((top + i) * all + left + j)];
                    }
                }
                pixels.push_back(sum);
            }
        }
        double squares = 0.0;
        for (int y = 1; y <= side_; ++y) {
            for (int x = 1; x <= side_; ++x) {
                double around = 0.0;
                for (int i = -1; i <= 1; ++i) {
                    for (int j = -1; j <= 1; ++j) {
                        around += pixels[static_cast<std::size_t>((y + i) * wide + x + j)];
                    }
                }
                const double own = pixels[static_cast<std::size_t>(y * wide + x)];
                squares += std::pow(own - (around - own) / 8.0, 2);
            }
        }
        return std::sqrt(8.0 / 9.0 * squares / (side_ * side_));
    }

    /// The same of a radiance that is one along each row.
    double deviationOfRows(const std::function<double(double up)>& radiance) const {
        const int edge = reach_ + 1, cells = 2 * reach_ * samples_;
        std::vector<double> field, pixels;
        for (int y = 0; y < (side_ + 2 * edge) * samples_; ++y) {
            field.push_back(radiance(-tangent(y, edge)));
        }
        for (int y = 0; y < side_ + 2; ++y) {
            const int top = (y + edge - 1) * samples_ + samples_ / 2 - reach_ * samples_;
            double sum = 0.0;
            for (int i = 0; i < cells; ++i) {
                const auto row = energies_.begin() + static_cast<std::ptrdiff_t>(i) * cells;
                sum += std::accumulate(row, row + cells, 0.0) *
                       field[static_cast<std::size_t>(top + i)];
            }
            pixels.push_back(sum);
        }
        double squares = 0.0;
        for (std::size_t y = 1; y + 1 < pixels.size(); ++y) {
            // Of eight neighbours two have the pixel's own value.
            squares += std::pow(0.75 * (pixels[y] - 0.5 * (pixels[y - 1] + pixels[y + 1])), 2);
        }
        return std::sqrt(8.0 / 9.0 * squares / side_);
    }

  private:
    double offset(int cell) const { return (cell + 0.5) / samples_ - reach_; }
    double tangent(int sample, int edge) const {
        return ((sample + 0.5) / samples_ - edge - 0.5 * side_) * angle_rad_;
    }

    int side_, samples_, reach_;
    double angle_rad_;
    std::vector<double> energies_;
};

/// A square tile of ground with a texture that repeats.
struct Ground {
    static constexpr int texels = 256;
    double side_m;
    std::vector<std::uint8_t> values; ///< row by row from the south

    double at(double x_m, double y_m) const {
        const double u = x_m / side_m * texels - 0.5, v = y_m / side_m * texels - 0.5;
        const double column = std::floor(u), row = std::floor(v);
        const auto texel = [&](double c, double r) {
            const auto wrapped = [](double i) {
                return static_cast<std::size_t>(i - texels * std::floor(i / texels));
            };
            return static_cast<double>(values[wrapped(r) * texels + wrapped(c)]) / 255.0;
        };
        return std::lerp(std::lerp(texel(column, row), texel(column + 1, row), u - column),
                         std::lerp(texel(column, row + 1), texel(column + 1, row + 1), u - column),
                         v - row);
    }
    /// An .obj with its texture: a plane of `count` tiles a side at altitude 0.
    void save(const TemporaryFolder& folder, int count) const {
        irsg::Canvas picture(texels, texels);
        for (int y = 0; y < texels; ++y) {
            for (int x = 0; x < texels; ++x) {
                const std::uint8_t value = values[static_cast<std::size_t>(y * texels + x)];
                picture.set(x, texels - 1 - y, {value, value, value});
            }
        }
        irsg::writePng(picture, folder / "ground.png");
        write(folder / "ground.mtl", "newmtl ground\nmap_Kd ground.png\n");
        // The axes of OBJ files are y up.
        const double half_m = 0.5 * count * side_m;
        std::string text = "mtllib ground.mtl\nusemtl ground\n";
        const std::pair<double, double> corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        for (const auto& [x, y] : corners) {
            text +=
                "v " + irsg::numberText(x * half_m) + " 0 " + irsg::numberText(-y * half_m) + "\n";
        }
        for (const auto& [x, y] : corners) {
            text += "vt " + irsg::numberText(0.5 * x * count) + " " +
                    irsg::numberText(0.5 * y * count) + "\n";
        }
        write(folder / "ground.obj", text + "f 1/1 2/2 3/3 4/4\n");
    }
};

/// Patches of several texels.
Ground patches(double side_m) {
    Ground ground{side_m, std::vector<std::uint8_t>(Ground::texels * Ground::texels)};
    std::mt19937 random(7);
    std::uniform_int_distribution<int> any(40, 215);
    constexpr int patch = 8;
    std::vector<std::uint8_t> coarse(Ground::texels * Ground::texels / patch / patch);
    for (std::uint8_t& value : coarse) {
        value = static_cast<std::uint8_t>(any(random));
    }
    for (int y = 0; y < Ground::texels; ++y) {
        for (int x = 0; x < Ground::texels; ++x) {
            ground.values[static_cast<std::size_t>(y * Ground::texels + x)] =
                coarse[static_cast<std::size_t>(y / patch * (Ground::texels / patch) + x / patch)];
        }
    }
    return ground;
}

/// Waves of four directions that fit into the tile.
Ground waves(double side_m) {
    Ground ground{side_m, std::vector<std::uint8_t>(Ground::texels * Ground::texels)};
    const std::pair<int, int> crests[] = {{3, 5}, {-4, 7}, {6, 1}, {9, 11}};
    for (int y = 0; y < Ground::texels; ++y) {
        for (int x = 0; x < Ground::texels; ++x) {
            double height = 0.0;
            for (const auto& [u, v] : crests) {
                height +=
                    std::sin(2.0 * std::numbers::pi * (u * x + v * y + 17.0 * u) / Ground::texels);
            }
            ground.values[static_cast<std::size_t>(y * Ground::texels + x)] =
                static_cast<std::uint8_t>(std::lround(127.5 + 30.0 * height));
        }
    }
    return ground;
}

/// The side of the square that counts: 128 pixels less the margins.
int countedSide() {
    const irsg::SensorDescription sensor = smallSensor();
    return 128 - 2 * (static_cast<int>(std::ceil(irsg::SensorTransfer(sensor).spread_rad() /
                                                 sensor.pixelAngle_rad())) +
                      1);
}

/// The clutter as a difference of radiance, of what the command states in K.
double radianceOf(double clutter_K) {
    const irsg::PixelResponse response(smallSensor());
    return clutter_K * response.contrast_per_K(300.0) / response.signalPerRadiance();
}

TEST(SmatBatchDetectionClutter, OfTexturedGroundIsThatOfADirectSum) {
    struct Row {
        const char* name;
        Ground ground;
        int tiles, samples;
        double elevation_deg, range_m, tolerance;
    };
    for (const Row& row :
         {Row{"patches from above", patches(80.0), 40, 6, 60.0, 3000.0, 0.06},
          Row{"waves of a sea at 12 degrees", waves(300.0), 80, 6, 12.0, 3000.0, 0.06}}) {
        const TemporaryFolder folder;
        row.ground.save(folder, row.tiles);
        const Ran ran = smatBatch(with({"detection",
                                        sample("sphere/sphere.smat"),
                                        "--sensor",
                                        sensorFile(folder),
                                        "--step",
                                        "180",
                                        "--offset",
                                        irsg::numberText(row.elevation_deg),
                                        "--range",
                                        irsg::numberText(row.range_m),
                                        "--altitude",
                                        "50",
                                        "--terrain",
                                        folder / "ground.obj",
                                        "--terrain-altitude",
                                        "0",
                                        "--terrain-slope",
                                        "2",
                                        "--clutter",
                                        "auto",
                                        "--background-temperature",
                                        "300",
                                        "--out",
                                        folder / "c.csv"},
                                       plain));
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        const ResultTable table = ResultTable::load(folder / "c.csv");
        const DirectClutter direct(smallSensor(), countedSide(), row.samples);
        for (std::size_t i = 0; i < 2; ++i) {
            const double azimuth_rad = std::numbers::pi * valueOf(table, "azimuth", i) / 180.0;
            const irsg::Vec3 target{0.0, 0.0, 50.0};
            const irsg::Viewpoint eye =
                irsg::Viewpoint::about(target, 0.0, azimuth_rad,
                                       std::numbers::pi * row.elevation_deg / 180.0, row.range_m);
            const double expected = direct.deviation([&](double right, double up) {
                const irsg::Vec3 towards = eye.forward() + eye.right * right + eye.up * up;
                const double length = -eye.position_m.z / towards.z;
                const irsg::Vec3 hit = eye.position_m + towards * length;
                return 2.0 * row.ground.at(hit.x, hit.y);
            });
            const double found = radianceOf(valueOf(table, "clutter", i));
            const double error = radianceOf(valueOf(table, "error_clutter", i));
            EXPECT_NEAR(found, expected, row.tolerance * expected + error)
                << row.name << ", azimuth " << valueOf(table, "azimuth", i);
            EXPECT_LT(error, 0.2 * found) << row.name;
        }
    }
}

TEST(SmatBatchDetectionClutter, OfTheHorizonIsThatOfItsRows) {
    const TemporaryFolder folder;
    const std::filesystem::path air =
        std::filesystem::path(SMAT_SOURCE_DIR) / "resources/atmospheres/temperate-maritime.xml";
    constexpr double range_m = 12000.0, altitude_m = 60.0;
    const Ran ran =
        smatBatch(with({"detection", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder),
                        "--step", "180", "--range", irsg::numberText(range_m), "--altitude",
                        irsg::numberText(altitude_m), "--atmosphere", air.string(), "--clutter",
                        "auto", "--background-temperature", "300", "--out", folder / "c.csv"},
                       plain));
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "c.csv");
    const irsg::SensorDescription sensor = smallSensor();
    const auto atmosphere = irsg::AtmosphereSmart::fromXml(air);
    irsg::Environment environment;
    environment.add(atmosphere);
    environment.sun.azimuth_rad = std::numbers::pi;
    environment.sun.elevation_rad = 0.25 * std::numbers::pi;
    const irsg::TargetView apparent = environment.targetView(
        {.sensorAltitude_m = altitude_m, .targetAltitude_m = altitude_m, .range_m = range_m},
        sensor.band().range());
    const DirectClutter direct(sensor, countedSide(), 16);
    for (std::size_t i = 0; i < 2; ++i) {
        // The camera looks back to where it stands from.
        const double azimuth_rad = std::numbers::pi * (1.0 + valueOf(table, "azimuth", i) / 180.0);
        const double expected = direct.deviationOfRows([&](double up) {
            double sum = 0.0;
            const auto spectrum = environment.spectrum(
                irsg::AtmosphericQuery::backgroundRadiance(
                    {altitude_m, apparent.elevation_rad + std::atan(up), azimuth_rad},
                    environment.sun),
                sensor.band().range());
            constexpr int steps = 200;
            for (int k = 0; k < steps; ++k) {
                sum += spectrum.value.at(4.0 + 0.1 * (k + 0.5) / steps) * 0.1 / steps;
            }
            return sum;
        });
        EXPECT_NEAR(radianceOf(valueOf(table, "clutter", i)), expected, 0.08 * expected) << i;
        // Towards the sun sea and sky differ more.
        EXPECT_GT(valueOf(table, "clutter", i), i == 0 ? 5e-3 : 5e-4) << i;
    }
}

TEST(SmatBatchDetectionClutter, ClutterOfAnEvenBackgroundIsNone) {
    const TemporaryFolder folder;
    const auto tableOf = [&](const std::vector<std::string>& more) {
        const Ran ran = smatBatch(with(
            with({"detection", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder),
                  "--step", "180", "--background-temperature", "300", "--out", folder / "c.csv"},
                 plain),
            more));
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(folder / "c.csv");
    };
    const ResultTable even = tableOf({"--range", "20000", "--clutter", "auto"});
    EXPECT_NEAR(valueOf(even, "clutter", 0), 0.0, 1e-9);
    EXPECT_NEAR(valueOf(even, "detection_range", 0) / valueOf(tableOf({}), "detection_range", 0),
                1.0, 1e-6);
    EXPECT_EQ(even.provenance.value("detection.clutter"), "of the background's pixels");
    // A target that fills the frame hides nothing of what would be behind it.
    const ResultTable near = tableOf({"--range", "30", "--clutter", "auto"});
    EXPECT_NEAR(valueOf(near, "clutter", 0), 0.0, 1e-9);
    irsg::SensorDescription blurred = smallSensor();
    blurred.motion.jitter_urad = 2e3;
    saveSensor(blurred, folder / "blurred.smatsensor");
    const Ran wide = smatBatch(
        with({"detection", sample("sphere/sphere.smat"), "--sensor", folder / "blurred.smatsensor",
              "--step", "180", "--clutter", "auto", "--out", folder / "x.csv"},
             plain));
    EXPECT_EQ(wide.exitCode, 2);
    EXPECT_THAT(wide.err, HasSubstr("clutter"));
}

} // namespace

} // namespace smat::test
