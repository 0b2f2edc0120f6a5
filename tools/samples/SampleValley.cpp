#include "tools/samples/SampleValley.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <png.h>

#include "irsg/core/Errors.h"
#include "tools/samples/Noise.h"
#include "tools/samples/TexturedGround.h"

namespace smat {

namespace {

constexpr int skySide = 512, groundSide = 512;
constexpr int gridSide = 112;          // cells of the terrain
constexpr double terrainSide_m = 16e3; // from edge to edge

/// A grey picture of 16 bits, linear, top row first. The last bits are left out: they are noise
/// that no viewer sees and every file carries.
void writeGrey(const std::filesystem::path& file, int side, const std::vector<double>& values) {
    std::vector<std::uint16_t> pixels;
    for (const double value : values) {
        const double steps = std::round(std::clamp(value, 0.0, 1.0) * 2047.0);
        pixels.push_back(static_cast<std::uint16_t>(std::lround(steps / 2047.0 * 65535.0)));
    }
    png_image picture{};
    picture.version = PNG_IMAGE_VERSION;
    picture.width = picture.height = static_cast<png_uint_32>(side);
    picture.format = PNG_FORMAT_LINEAR_Y;
    if (png_image_write_to_file(&picture, file.c_str(), 0, pixels.data(), 0, nullptr) == 0)
        throw irsg::InputError({file.string(), "", picture.message, "a file that can be written"});
}

/// Thickness of the clouds along a direction: a layer of fractal lumps over flat ground, thinning
/// into the haze of the horizon.
double cloud(double x, double y, double z) {
    const double length = std::sqrt(x * x + y * y + z * z);
    const double up = z / length;
    if (up <= 0.0)
        return 0.0;
    // A bent layer, so that lumps do not shrink to nothing towards the horizon.
    const double reach = 2.2 / (up + 0.18);
    const double px = x / length * reach, py = y / length * reach;
    const double lumps = fractalNoise(px + 5.0, py + 8.0, 0.5, 6);
    const double patches = fractalNoise(0.35 * px - 3.0, 0.35 * py + 2.0, 7.5, 2);
    const double thickness = smoothStep(0.46, 0.74, lumps + 0.35 * (patches - 0.5));
    return thickness * (0.55 + 0.45 * lumps) * smoothStep(0.0, 0.14, up);
}

double height_m(double x_m, double y_m) {
    const double x = x_m / 2600.0, y = y_m / 2600.0;
    const double lumps = fractalNoise(x + 11.0, y + 4.0, 1.5, 6);
    const double ridges = 1.0 - std::abs(2.0 * fractalNoise(x - 7.0, y + 13.0, 3.5, 5) - 1.0);
    // The valley winds about x = 0 and is as flat as a river leaves it.
    const double middle_m = 500.0 * std::sin(y_m / 2300.0);
    const double slopes = smoothStep(350.0, 3600.0, std::abs(x_m - middle_m));
    return 40.0 + 30.0 * lumps + slopes * (330.0 * lumps + 900.0 * ridges * ridges * ridges);
}

double groundTexel(double x_m, double y_m) {
    const double h_m = height_m(x_m, y_m);
    constexpr double step_m = 60.0;
    const double steepness =
        std::hypot(height_m(x_m + step_m, y_m) - h_m, height_m(x_m, y_m + step_m) - h_m) / step_m;
    // South-western slopes have the afternoon sun.
    const double sunny = (height_m(x_m + step_m, y_m + step_m) - h_m) / step_m;
    const double woods = smoothStep(0.46, 0.58, fractalNoise(x_m / 700.0, y_m / 700.0, 9.5, 5));
    const double rock = smoothStep(0.32, 0.62, steepness + 0.0003 * (h_m - 500.0));
    const double meadows = 0.06 * (fractalNoise(x_m / 240.0, y_m / 240.0, 2.5, 3) - 0.5);
    return 0.52 + meadows - 0.16 * woods * (1.0 - rock) + 0.2 * rock + 0.25 * sunny;
}

} // namespace

void writeCloudSkybox(const std::filesystem::path& folder) {
    using Direction = std::array<double, 3>;
    struct Face {
        const char* name;
        Direction (*at)(double right, double down);
    };
    const Face faces[] = {
        {"north",
         [](double r, double d) {
             return Direction{r, 1, -d};
         }},
        {"south",
         [](double r, double d) {
             return Direction{-r, -1, -d};
         }},
        {"east",
         [](double r, double d) {
             return Direction{1, -r, -d};
         }},
        {"west",
         [](double r, double d) {
             return Direction{-1, r, -d};
         }},
        {"up",
         [](double r, double d) {
             return Direction{r, d, 1};
         }},
        {"down",
         [](double r, double d) {
             return Direction{r, -d, -1};
         }},
    };
    std::filesystem::create_directories(folder);
    for (const Face& face : faces) {
        std::vector<double> values;
        for (int y = 0; y < skySide; ++y)
            for (int x = 0; x < skySide; ++x) {
                const Direction d =
                    face.at((2.0 * x + 1.0) / skySide - 1.0, (2.0 * y + 1.0) / skySide - 1.0);
                values.push_back(cloud(d[0], d[1], d[2]));
            }
        writeGrey(folder / (std::string(face.name) + ".png"), skySide, values);
    }
}

void writeValleyTerrain(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    std::vector<double> texels;
    for (int y = 0; y < groundSide; ++y)
        for (int x = 0; x < groundSide; ++x)
            texels.push_back(groundTexel(((x + 0.5) / groundSide - 0.5) * terrainSide_m,
                                         (0.5 - (y + 0.5) / groundSide) * terrainSide_m));
    const std::filesystem::path picture = folder / "ground.png";
    writeGrey(picture, groundSide, texels);

    const GroundSheet sheet{
        "ground.png", osg::Texture::CLAMP_TO_EDGE, gridSide, [](int i, int j) {
            const double u = static_cast<double>(i) / gridSide;
            const double v = static_cast<double>(j) / gridSide;
            const double x_m = (u - 0.5) * terrainSide_m, y_m = (v - 0.5) * terrainSide_m;
            return GroundCorner{osg::Vec3(static_cast<float>(x_m), static_cast<float>(y_m),
                                          static_cast<float>(std::round(height_m(x_m, y_m)))),
                                osg::Vec2(static_cast<float>(u), static_cast<float>(v))};
        }};
    writeTexturedGround(folder / "valley.osgb", {&sheet, 1});
}

} // namespace smat
