#include "irsg/render/background/TexturePyramid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace irsg {

namespace {

/// The texel that stands at a place of an axis beyond or within its ends.
int wrapped(int i, int size, TextureWrap mode) {
    switch (mode) {
    case TextureWrap::repeat:
        return ((i % size) + size) % size;
    case TextureWrap::mirror: {
        const int twice = ((i % (2 * size)) + 2 * size) % (2 * size);
        return twice < size ? twice : 2 * size - 1 - twice;
    }
    default:
        return std::clamp(i, 0, size - 1);
    }
}

/// The part of an axis that a texel of the next level covers, in texels of this one.
struct Share {
    int first = 0;
    std::vector<double> weights;
};

Share shareOf(int i, int fine, int coarse) {
    const double size = static_cast<double>(fine) / coarse;
    const double begin = i * size, end = (i + 1) * size;
    Share share{static_cast<int>(begin), {}};
    for (int k = share.first; k < fine && k < end; ++k)
        share.weights.push_back((std::min(end, k + 1.0) - std::max(begin, k + 0.0)) / size);
    return share;
}

} // namespace

TexturePyramid::TexturePyramid(const TextureImage& image, TextureWrap wrapS, TextureWrap wrapT)
    : wrapS_(wrapS), wrapT_(wrapT) {
    Level level{image.width_px, image.height_px, {}};
    const auto width = static_cast<std::size_t>(image.width_px);
    for (auto y = static_cast<std::size_t>(image.height_px); y-- > 0;)
        level.values.insert(level.values.end(),
                            image.values.begin() + static_cast<std::ptrdiff_t>(y * width),
                            image.values.begin() + static_cast<std::ptrdiff_t>((y + 1) * width));
    levels_.push_back(std::move(level));
    while (levels_.back().width > 1 || levels_.back().height > 1)
        levels_.push_back(halved(levels_.back()));
}

TexturePyramid::Level TexturePyramid::halved(const Level& level) {
    Level next{std::max(level.width / 2, 1), std::max(level.height / 2, 1), {}};
    for (int y = 0; y < next.height; ++y) {
        const Share rows = shareOf(y, level.height, next.height);
        for (int x = 0; x < next.width; ++x) {
            const Share columns = shareOf(x, level.width, next.width);
            double sum = 0.0;
            for (std::size_t j = 0; j < rows.weights.size(); ++j) {
                const auto row = static_cast<std::size_t>(rows.first) + j;
                const float* values = &level.values[row * static_cast<std::size_t>(level.width) +
                                                    static_cast<std::size_t>(columns.first)];
                for (std::size_t i = 0; i < columns.weights.size(); ++i)
                    sum += rows.weights[j] * columns.weights[i] * static_cast<double>(values[i]);
            }
            next.values.push_back(static_cast<float>(sum));
        }
    }
    return next;
}

double TexturePyramid::bilinear(const Level& level, double s, double t) const {
    const double x = s * level.width - 0.5, y = t * level.height - 0.5;
    const double left = std::floor(x), below = std::floor(y);
    const double partX = x - left, partY = y - below;
    const auto texel = [&](int dx, int dy) {
        const int i = wrapped(static_cast<int>(left) + dx, level.width, wrapS_);
        const int j = wrapped(static_cast<int>(below) + dy, level.height, wrapT_);
        return static_cast<double>(
            level.values[static_cast<std::size_t>(j) * static_cast<std::size_t>(level.width) +
                         static_cast<std::size_t>(i)]);
    };
    return (1.0 - partY) * ((1.0 - partX) * texel(0, 0) + partX * texel(1, 0)) +
           partY * ((1.0 - partX) * texel(0, 1) + partX * texel(1, 1));
}

double TexturePyramid::at(double s, double t, const double (&across)[2],
                          const double (&down)[2]) const {
    const Level& finest = levels_.front();
    const double texels = std::max(std::hypot(across[0] * finest.width, across[1] * finest.height),
                                   std::hypot(down[0] * finest.width, down[1] * finest.height));
    const double most = static_cast<double>(levels_.size() - 1);
    const double level = texels > 1.0 ? std::min(std::log2(texels), most) : 0.0;
    const auto lower = static_cast<std::size_t>(level);
    const double part = level - static_cast<double>(lower);
    const double value = bilinear(levels_[lower], s, t);
    return part > 0.0 ? (1.0 - part) * value + part * bilinear(levels_[lower + 1], s, t) : value;
}

} // namespace irsg
