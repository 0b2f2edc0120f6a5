#include "tools/samples/SampleSea.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <png.h>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "tools/samples/Noise.h"
#include "tools/samples/TexturedGround.h"

namespace smat {
namespace {

constexpr int texels = 512;
constexpr double tile_m = 256.0, halfSide_m = 6000.0;
constexpr int cells = 24;

/// A wave that fits into the tile.
struct Wave {
    int east, north; ///< lengths of it in the tile
    double phase;
};

/// Waves of `longest` to `shortest` m, as many in every octave: between the peak and the short
/// waves a wind sea has the same mean square slope in each (spectrum of k^-4, Phillips 1958). Their
/// directions are spread as the squared cosine about the wind, which blows to the north-east.
std::vector<Wave> waves(int count, double longest, double shortest, std::mt19937& random) {
    // Made by hand, since the distributions of the standard library differ from one to another.
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    std::vector<Wave> all;
    while (static_cast<int>(all.size()) < count) {
        const double along = std::numbers::pi * (uniform() - 0.5);
        if (uniform() > std::cos(along) * std::cos(along))
            continue;
        const double lengths = tile_m / (irsg::lerpByRatio(longest, shortest, uniform()));
        const double direction = along + std::numbers::pi / 4.0;
        const Wave wave{static_cast<int>(std::lround(lengths * std::sin(direction))),
                        static_cast<int>(std::lround(lengths * std::cos(direction))),
                        2.0 * std::numbers::pi * uniform()};
        if (wave.east != 0 || wave.north != 0)
            all.push_back(wave);
    }
    return all;
}

/// The sum of waves over the tile, with a mean square of 1.
std::vector<double> summed(const std::vector<Wave>& all) {
    std::vector<double> sum(static_cast<std::size_t>(texels) * texels, 0.0);
    const double amplitude = std::sqrt(2.0 / static_cast<double>(all.size()));
    for (const Wave& wave : all)
        for (int y = 0; y < texels; ++y)
            for (int x = 0; x < texels; ++x)
                sum[static_cast<std::size_t>(y) * texels + static_cast<std::size_t>(x)] +=
                    amplitude *
                    std::cos(2.0 * std::numbers::pi *
                                 (wave.east * (x + 0.5) + wave.north * (y + 0.5)) / texels +
                             wave.phase);
    return sum;
}

/// Slopes along the wind over the tile, in deviations of its rms; rows from the north.
std::vector<double> windSea() {
    std::mt19937 random(20111);
    constexpr double longest_m = 42.0, shortest_m = 1.5; // a wind of 7 m/s has its peak at 42 m
    std::vector<double> slopes = summed(waves(300, longest_m, shortest_m, random));
    // Gusts: where the sea is rougher and where it is smoother.
    const std::vector<double> gusts = summed(waves(12, 250.0, 60.0, random));
    for (std::size_t i = 0; i < slopes.size(); ++i)
        slopes[i] *= std::max(0.3, 1.0 + 0.35 * gusts[i]);
    return slopes;
}

void writeSlopes(const std::vector<double>& slopes, const std::filesystem::path& file) {
    // Four standard deviations from black to white on either side, in few steps: a smaller file.
    constexpr double deviations = 4.0, steps = 63.0;
    std::vector<std::uint8_t> pixels;
    for (const double slope : slopes) {
        const double value = std::clamp(0.5 + 0.5 * slope / deviations, 0.0, 1.0);
        pixels.push_back(
            static_cast<std::uint8_t>(std::lround(std::round(value * steps) / steps * 255.0)));
    }
    png_image picture{};
    picture.version = PNG_IMAGE_VERSION;
    picture.width = picture.height = texels;
    picture.format = PNG_FORMAT_GRAY;
    if (png_image_write_to_file(&picture, file.c_str(), 0, pixels.data(), 0, nullptr) == 0)
        throw irsg::InputError({file.string(), "", picture.message, "a file that can be written"});
}

/// The ship that makes the wake: its ends and half its breadth at the water, m, and its speed.
constexpr double bow_m = 34.0, stern_m = -36.0, halfBreadth_m = 5.2, speed_m_s = 9.0;
/// What the wake is drawn in: texels of the tile, moved by whole ones.
constexpr double westEdge_m = -128.0, northEdge_m = 70.0;

/// Slope to the side of the waves of a point of pressure that moves north, `behind` and
/// `right` of it, in any unit, and a part of that astern: the stationary waves of all directions
/// (Kelvin), of which those shorter than `blunt_m` fade as those of something blunt do.
double kelvinSlope(double behind, double right, double blunt_m) {
    constexpr double gravity = 9.81;
    constexpr int directions = 200;
    const double longest = gravity / (speed_m_s * speed_m_s); // of the wave numbers the smallest
    double sum = 0.0;
    for (int i = 0; i < directions; ++i) {
        const double along = std::numbers::pi * ((i + 0.5) / directions - 0.5);
        const double secant = 1.0 / std::cos(along);
        const double number = longest * secant * secant;
        const double fading = std::exp(-0.25 * number * number * blunt_m * blunt_m);
        if (fading < 1e-4)
            continue;
        const double phase = number * (behind * std::cos(along) + right * std::sin(along));
        sum += fading * secant * secant * number * (std::sin(along) - 0.4 * std::cos(along)) *
               std::cos(phase);
    }
    return sum / directions;
}

/// 1 at the middle of a ridge, 0 beside it.
double ridge(double off, double halfWidth) {
    return std::exp(-off * off / (halfWidth * halfWidth));
}

/// Waves of bow and stern, smooth water with foam behind the ship and foam along its bow wave.
/// Strengths are assumed.
std::vector<double> wakeOf(const std::vector<double>& sea) {
    std::vector<double> wake(sea.size());
    constexpr double texel_m = tile_m / texels;
    constexpr int columnsWest = static_cast<int>(-westEdge_m / texel_m);
    constexpr int rowsNorth = static_cast<int>(northEdge_m / texel_m);
    for (int y = 0; y < texels; ++y)
        for (int x = 0; x < texels; ++x) {
            const double east = westEdge_m + (x + 0.5) * texel_m;
            const double north = northEdge_m - (y + 0.5) * texel_m;
            const int column = (x + texels - columnsWest) % texels;
            const int row = (y + texels - rowsNorth) % texels;
            double slope =
                sea[static_cast<std::size_t>(row) * texels + static_cast<std::size_t>(column)];

            double made = 0.0;
            for (const auto& [from, strength] :
                 {std::pair(bow_m - 2.0, 1.0), std::pair(stern_m + 4.0, -0.8)}) {
                const double behind = from - north;
                if (behind > 0.0)
                    made +=
                        strength * smoothStep(0.0, 12.0, behind) * kelvinSlope(behind, east, 3.0);
            }
            slope += 9.0 * made;

            const double foam = fractalNoise(0.9 * east, 0.45 * north, 0.0, 4);
            const double astern = stern_m + 4.0 - north;
            if (astern > 0.0) {
                const double half = halfBreadth_m * (0.9 + 0.35 * std::sqrt(astern / 20.0));
                const double inside = 1.0 - smoothStep(0.75 * half, 1.1 * half, std::abs(east));
                const double fresh = std::exp(-astern / 45.0);
                slope *= 1.0 - 0.75 * inside;
                slope += inside * (4.5 * fresh * smoothStep(0.42, 0.58, foam) - 0.5);
            }
            const double aft = bow_m + 1.0 - north;
            if (aft > 0.0) {
                // From the stem outwards, and what it leaves along the hull.
                const double crest = 0.8 + 0.30 * aft + 1.2 * smoothStep(0.0, 6.0, aft);
                const double broken = smoothStep(0.38, 0.55, foam);
                slope += 4.5 * std::exp(-aft / 30.0) * broken *
                         ridge(std::abs(east) - crest, 0.7 + 0.03 * aft);
                slope += 3.0 * broken * std::exp(-aft / 90.0) * smoothStep(4.0, 14.0, aft) *
                         ridge(std::abs(east) - halfBreadth_m, 1.3) * (north > stern_m ? 1.0 : 0.0);
            }
            // Into the sea around it.
            const double edge = std::min({east - westEdge_m, westEdge_m + tile_m - east,
                                          north - northEdge_m + tile_m, northEdge_m - north});
            const double own =
                sea[static_cast<std::size_t>(row) * texels + static_cast<std::size_t>(column)];
            wake[static_cast<std::size_t>(y) * texels + static_cast<std::size_t>(x)] =
                std::lerp(own, slope, smoothStep(0.0, 24.0, edge));
        }
    return wake;
}

GroundCorner cornerAt(double x_m, double y_m, double u, double v) {
    return {osg::Vec3(static_cast<float>(x_m), static_cast<float>(y_m), 0.0F),
            osg::Vec2(static_cast<float>(u), static_cast<float>(v))};
}

} // namespace

void writeSea(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const std::vector<double> sea = windSea();
    writeSlopes(sea, folder / "waves.png");
    const GroundSheet all{"waves.png", osg::Texture::REPEAT, cells, [](int i, int j) {
                              const double x_m = (2.0 * i / cells - 1.0) * halfSide_m;
                              const double y_m = (2.0 * j / cells - 1.0) * halfSide_m;
                              return cornerAt(x_m, y_m, x_m / tile_m, y_m / tile_m);
                          }};
    writeTexturedGround(folder / "sea.osgb", {&all, 1});

    writeSlopes(wakeOf(sea), folder / "wake.png");
    // The lines about the middle become the edges of the wake.
    constexpr double south = northEdge_m - tile_m;
    const auto line = [](int i, double low, double high) {
        constexpr int middle = cells / 2;
        if (i <= middle)
            return i == middle ? low : (2.0 * i / cells - 1.0) * halfSide_m;
        return i == middle + 1 ? high : (2.0 * (i - 1) / cells - 1.0) * halfSide_m;
    };
    const std::array sheets{
        GroundSheet{"waves.png", osg::Texture::REPEAT, cells + 1,
                    [&](int i, int j) {
                        const double x_m = line(i, westEdge_m, westEdge_m + tile_m);
                        const double y_m = line(j, south, northEdge_m);
                        return cornerAt(x_m, y_m, x_m / tile_m, y_m / tile_m);
                    },
                    [](int i, int j) { return i != cells / 2 || j != cells / 2; }},
        GroundSheet{"wake.png", osg::Texture::CLAMP_TO_EDGE, 1, [&](int i, int j) {
                        return cornerAt(westEdge_m + i * tile_m, south + j * tile_m, i, j);
                    }}};
    writeTexturedGround(folder / "wake.osgb", sheets);
}

} // namespace smat
