#include "apps/samples/SampleSea.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include <png.h>

#include "apps/samples/TexturedGround.h"
#include "irsg/radiometry/Errors.h"

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
        const double lengths = tile_m / (longest * std::pow(shortest / longest, uniform()));
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

void writeWaves(const std::filesystem::path& file) {
    std::mt19937 random(20111);
    constexpr double longest_m = 42.0, shortest_m = 1.5; // a wind of 7 m/s has its peak at 42 m
    const std::vector<double> slopes = summed(waves(300, longest_m, shortest_m, random));
    // Gusts: where the sea is rougher and where it is smoother.
    const std::vector<double> gusts = summed(waves(12, 250.0, 60.0, random));
    // Four standard deviations from black to white on either side, in few steps: a smaller file.
    constexpr double deviations = 4.0, steps = 63.0;
    std::vector<std::uint8_t> pixels;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const double slope = slopes[i] * std::max(0.3, 1.0 + 0.35 * gusts[i]);
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

} // namespace

void writeSea(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    writeWaves(folder / "waves.png");

    writeTexturedGround(
        folder / "sea.osgb", "waves.png", osg::Texture::REPEAT, cells, [](int i, int j) {
            const double x_m = (2.0 * i / cells - 1.0) * halfSide_m;
            const double y_m = (2.0 * j / cells - 1.0) * halfSide_m;
            return GroundCorner{
                osg::Vec3(static_cast<float>(x_m), static_cast<float>(y_m), 0.0F),
                osg::Vec2(static_cast<float>(x_m / tile_m), static_cast<float>(y_m / tile_m))};
        });
}

} // namespace smat
