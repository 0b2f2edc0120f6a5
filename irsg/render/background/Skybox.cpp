#include "irsg/render/background/Skybox.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Outward axis of a face and the axes of its picture.
struct FaceAxes {
    Vec3 outward, right, up;
};
constexpr std::array<FaceAxes, 6> axes{{
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
    {{0, -1, 0}, {-1, 0, 0}, {0, 0, 1}},
    {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
    {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
    {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}},
}};

/// Where a direction meets the cube: face, and -1 to 1 to the right and downwards in its picture.
struct CubePoint {
    std::size_t face;
    double right, down;
    double outward; ///< component of the direction along the face's axis
};

CubePoint onCube(const Vec3& d) {
    const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    if (z >= x && z >= y)
        return d.z >= 0.0 ? CubePoint{4, d.x / z, d.y / z, z} : CubePoint{5, d.x / z, -d.y / z, z};
    if (y >= x)
        return d.y >= 0.0 ? CubePoint{0, d.x / y, -d.z / y, y}
                          : CubePoint{1, -d.x / y, -d.z / y, y};
    return d.x >= 0.0 ? CubePoint{2, -d.y / x, -d.z / x, x} : CubePoint{3, d.y / x, -d.z / x, x};
}

/// A texel's centre in -1 to 1; a neighbour outside the face lies beyond.
double centreOf(int texel, int size) {
    return (2.0 * texel + 1.0) / size - 1.0;
}
int texelOf(double place, int size) {
    return std::clamp(static_cast<int>(std::floor(0.5 * (place + 1.0) * size)), 0, size - 1);
}

Vec3 directionOf(std::size_t face, double right, double down) {
    const FaceAxes& a = axes[face];
    return a.outward + a.right * right - a.up * down;
}

} // namespace

void Skybox::Level::fillBorders() {
    for (std::size_t face = 0; face < 6; ++face) {
        const FaceAxes& a = axes[face];
        // Over an edge lies the first row of the face that stands at a right angle to this one.
        const auto beyond = [&](const Vec3& outward, const Vec3& along, double place) {
            const Vec3 p = outward + a.outward * (1.0 - 1.0 / size) + along * place;
            const CubePoint on = onCube(p);
            return texels[index(on.face, texelOf(on.right, size), texelOf(on.down, size))];
        };
        for (int i = 0; i < size; ++i) {
            const double place = centreOf(i, size);
            texels[index(face, -1, i)] = beyond(a.right * -1.0, a.up, -place);
            texels[index(face, size, i)] = beyond(a.right, a.up, -place);
            texels[index(face, i, -1)] = beyond(a.up, a.right, place);
            texels[index(face, i, size)] = beyond(a.up * -1.0, a.right, place);
        }
    }
    // Three faces meet in a corner: there, each sees the mean of the three.
    for (std::size_t face = 0; face < 6; ++face)
        for (const int x : {-1, size})
            for (const int y : {-1, size}) {
                const int inX = x < 0 ? 0 : size - 1, inY = y < 0 ? 0 : size - 1;
                texels[index(face, x, y)] =
                    (texels[index(face, inX, inY)] + texels[index(face, x, inY)] +
                     texels[index(face, inX, y)]) /
                    3.0f;
            }
}

double Skybox::Level::at(std::size_t face, double right, double down) const {
    const double x = std::clamp(0.5 * (right + 1.0) * size + 0.5, 0.0, size + 0.999999);
    const double y = std::clamp(0.5 * (down + 1.0) * size + 0.5, 0.0, size + 0.999999);
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    const double toRight = x - static_cast<double>(column), toBelow = y - static_cast<double>(row);
    const float* first = texels.data() + (face * stride() + row) * stride() + column;
    const double a = first[0], b = first[1], c = first[stride()], d = first[stride() + 1];
    const double above = a + toRight * (b - a), below = c + toRight * (d - c);
    return above + toBelow * (below - above);
}

Skybox::Skybox(std::array<TextureImage, 6> faces, const std::array<std::string, 6>& names) {
    const int size = faces[0].width_px;
    std::vector<Diagnostic> diagnostics;
    for (std::size_t face = 0; face < 6; ++face) {
        const TextureImage& image = faces[face];
        const std::string found =
            std::to_string(image.width_px) + " x " + std::to_string(image.height_px) + " texels";
        const std::string who =
            names[face].empty() ? "skybox face " + std::string(faceNames[face]) : names[face];
        if (image.width_px < 1 || image.width_px != image.height_px)
            diagnostics.push_back({who, "", found, "a square picture"});
        else if (image.width_px != size)
            diagnostics.push_back({who, "", found,
                                   "the size of the north face, " + std::to_string(size) + " x " +
                                       std::to_string(size)});
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));

    Level finest;
    finest.size = size;
    finest.texels.resize(6 * finest.stride() * finest.stride());
    for (std::size_t face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                finest.texels[finest.index(face, x, y)] =
                    faces[face]
                        .values[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
                                static_cast<std::size_t>(x)];
    finest.fillBorders();
    levels_.push_back(std::move(finest));
    while (levels_.back().size > 1)
        levels_.push_back(halved(levels_.back()));
    brightSpot_rad_ = findBrightSpot();
}

Skybox::Level Skybox::halved(const Level& finer) const {
    Level result;
    result.size = std::max(finer.size / 2, 1);
    result.texels.resize(6 * result.stride() * result.stride());
    // Of an odd number of texels some count to two means, in part.
    const double step = static_cast<double>(finer.size) / result.size;
    struct Share {
        int texel;
        double weight;
    };
    std::vector<std::vector<Share>> shares(static_cast<std::size_t>(result.size));
    for (int i = 0; i < result.size; ++i)
        for (int t = static_cast<int>(i * step); t < finer.size && t < (i + 1) * step; ++t)
            shares[static_cast<std::size_t>(i)].push_back(
                {t, (std::min(t + 1.0, (i + 1) * step) - std::max(1.0 * t, i * step)) / step});
    for (std::size_t face = 0; face < 6; ++face)
        for (int y = 0; y < result.size; ++y)
            for (int x = 0; x < result.size; ++x) {
                double sum = 0.0;
                for (const Share& down : shares[static_cast<std::size_t>(y)])
                    for (const Share& right : shares[static_cast<std::size_t>(x)])
                        sum += down.weight * right.weight *
                               static_cast<double>(
                                   finer.texels[finer.index(face, right.texel, down.texel)]);
                result.texels[result.index(face, x, y)] = static_cast<float>(sum);
            }
    result.fillBorders();
    return result;
}

double Skybox::at(const Vec3& direction) const {
    const CubePoint on = onCube(direction);
    return levels_.front().at(on.face, on.right, on.down);
}

std::vector<double> Skybox::pixels(const FieldRays& rays, const TextureScale& scale) const {
    std::vector<double> result;
    result.reserve(static_cast<std::size_t>(rays.width_px) *
                   static_cast<std::size_t>(rays.height_px));
    // A pixel's side on the face of the cube is pitch / outward^(3/2): solid angles are areas times
    // the cubes of the cosines on both planes. At the corner of a face outward is |d| / sqrt(3).
    const double texelsPerPitch = 0.5 * rays.pitch * faceSize();
    const bool averages = texelsPerPitch * std::pow(3.0, 0.75) > 1.0;
    const double fineness = std::log2(texelsPerPitch);
    for (int y = 0; y < rays.height_px; ++y) {
        const Vec3 start = rays.at(0.0, rays.v(y + 0.5));
        for (int x = 0; x < rays.width_px; ++x) {
            const double u = rays.u(x + 0.5);
            const CubePoint on = onCube({start.x + u * rays.right.x, start.y + u * rays.right.y,
                                         start.z + u * rays.right.z});
            const double level = averages ? fineness - 1.5 * std::log2(on.outward) : 0.0;
            double texel;
            if (level <= 0.0) {
                texel = levels_.front().at(on.face, on.right, on.down);
            } else {
                const auto finer = std::min(static_cast<std::size_t>(level), levels_.size() - 1);
                const auto coarser = std::min(finer + 1, levels_.size() - 1);
                const double a = levels_[finer].at(on.face, on.right, on.down);
                const double b = levels_[coarser].at(on.face, on.right, on.down);
                texel = a + (level - std::floor(level)) * (b - a);
            }
            result.push_back(scale.radiance_W_m2_sr(texel));
        }
    }
    return result;
}

std::optional<double> Skybox::findBrightSpot() const {
    const Level& level = levels_.front();
    std::vector<float> values;
    values.reserve(6 * level.stride() * level.stride());
    struct Brightest {
        std::size_t face = 0;
        int x = 0, y = 0;
    } brightest;
    for (std::size_t face = 0; face < 6; ++face)
        for (int y = 0; y < level.size; ++y)
            for (int x = 0; x < level.size; ++x) {
                const float value = level.texels[level.index(face, x, y)];
                if (values.empty() ||
                    value > level.texels[level.index(brightest.face, brightest.x, brightest.y)])
                    brightest = {face, x, y};
                values.push_back(value);
            }
    const float maximum = level.texels[level.index(brightest.face, brightest.x, brightest.y)];
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (!(maximum > *middle))
        return std::nullopt;
    const float threshold = 0.5f * (maximum + *middle);

    const auto directionAt = [&](std::size_t face, int x, int y) {
        return normalized(directionOf(face, centreOf(x, level.size), centreOf(y, level.size)));
    };
    const Vec3 centre = directionAt(brightest.face, brightest.x, brightest.y);
    double reach_rad = 0.0;
    for (std::size_t face = 0; face < 6; ++face)
        for (int y = 0; y < level.size; ++y)
            for (int x = 0; x < level.size; ++x)
                if (level.texels[level.index(face, x, y)] > threshold)
                    reach_rad = std::max(
                        reach_rad, 2.0 * std::asin(std::min(
                                             1.0, 0.5 * length(directionAt(face, x, y) - centre))));
    // The brightest texel may be at the rim of the spot; a texel has a width of its own.
    const double texel_rad = 2.0 / level.size;
    const double span_rad = reach_rad + texel_rad;
    return span_rad < radians(1.0) ? std::optional(span_rad) : std::nullopt;
}

} // namespace irsg
