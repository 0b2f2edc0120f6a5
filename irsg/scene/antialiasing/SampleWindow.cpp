#include "irsg/scene/antialiasing/SampleWindow.h"

#include <cmath>
#include <utility>

namespace irsg {

PixelWindow PixelWindow::unitedWith(const PixelWindow& other) const {
    if (empty())
        return other;
    if (other.empty())
        return *this;
    const int left = std::min(x, other.x), top = std::min(y, other.y);
    const int right = std::max(x + width, other.x + other.width);
    const int bottom = std::max(y + height, other.y + other.height);
    return {left, top, right - left, bottom - top};
}

bool PixelWindow::intersects(const PixelWindow& other) const {
    return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
           other.y < y + height;
}

bool ImageRectangle::intersects(const ImageRectangle& other) const {
    return !intersectedWith(other).empty();
}

ImageRectangle ImageRectangle::unitedWith(const ImageRectangle& other) const {
    if (empty())
        return other;
    if (other.empty())
        return *this;
    return {std::min(left, other.left), std::min(top, other.top), std::max(right, other.right),
            std::max(bottom, other.bottom)};
}

ImageRectangle ImageRectangle::intersectedWith(const ImageRectangle& other) const {
    return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
            std::min(bottom, other.bottom)};
}

SampleWindow SampleWindow::ofFrame(int side_px, std::vector<int> entities) {
    SampleWindow window;
    window.tilesWide = window.tilesHigh = side_px;
    window.entities = std::move(entities);
    return window;
}

double SampleWindow::tileSide_px() const {
    return std::ldexp(1.0, -level);
}

ImageRectangle SampleWindow::rectangle() const {
    const double side_px = tileSide_px();
    return {static_cast<double>(tileX) * side_px, static_cast<double>(tileY) * side_px,
            static_cast<double>(tileX + tilesWide) * side_px,
            static_cast<double>(tileY + tilesHigh) * side_px};
}

ImageRectangle SampleWindow::drawnRectangle() const {
    ImageRectangle drawn = rectangle();
    drawn.right = drawn.left + width() * tileSide_px() / samplesAcross;
    return drawn;
}

PixelWindow SampleWindow::pixels() const {
    const auto first = [&](std::int64_t tile) { return static_cast<int>(tile >> level); };
    const int x = first(tileX), y = first(tileY);
    return {x, y, first(tileX + tilesWide - 1) - x + 1, first(tileY + tilesHigh - 1) - y + 1};
}

double SampleWindow::share() const {
    return std::ldexp(1.0 / (static_cast<double>(samplesAcross) * samplesDown), -2 * level);
}

double SampleWindow::density() const {
    return std::ldexp(static_cast<double>(std::min(samplesAcross, samplesDown)), level);
}

std::vector<SampleWindow> SampleWindow::pieces(int side) const {
    const int across = std::max(1, side / samplesAcross), down = std::max(1, side / samplesDown);
    std::vector<SampleWindow> result;
    for (int y = 0; y < tilesHigh; y += down)
        for (int x = 0; x < tilesWide; x += across) {
            SampleWindow& piece = result.emplace_back(*this);
            piece.tileX += x;
            piece.tileY += y;
            piece.tilesWide = std::min(across, tilesWide - x);
            piece.tilesHigh = std::min(down, tilesHigh - y);
        }
    return result;
}

std::vector<char> SampleWindow::skippedOf(int row) const {
    const ImageRectangle all = rectangle();
    const double sampleWide_px = tileSide_px() / samplesAcross;
    const double y = all.top + (row + 0.5) * tileSide_px() / samplesDown;
    std::vector<char> skipped;
    for (const ImageRectangle& part : leftOut) {
        if (y < part.top || y >= part.bottom)
            continue;
        skipped.resize(static_cast<std::size_t>(width()));
        const auto column = [&](double x) {
            const double index = std::ceil((x - all.left) / sampleWide_px - 0.5);
            return static_cast<std::ptrdiff_t>(
                std::clamp(index, 0.0, static_cast<double>(width())));
        };
        std::fill(skipped.begin() + column(part.left), skipped.begin() + column(part.right), 1);
    }
    return skipped;
}

} // namespace irsg
