#include "irsg/geometry/conversion/PaintedGrid.h"

#include <algorithm>
#include <cmath>

namespace irsg {
namespace {

constexpr double toleranceOfDiagonal = 1e-4;
/// Cosine of the most that a face may be tilted against what was painted.
constexpr double leastFacing = 0.7;
/// Of the tolerance, within which a point lies on a triangle itself and not beside it.
constexpr double exactPart = 0.01;
constexpr std::uint64_t most = (std::uint64_t{1} << 20) - 1;

std::uint64_t place(double along) {
    return static_cast<std::uint64_t>(std::clamp(along, 0.0, double(most)));
}

} // namespace

PaintedGrid::PaintedGrid(const std::vector<PaintedSurface>& painted) {
    osg::Vec3d low(HUGE_VAL, HUGE_VAL, HUGE_VAL), high = -low;
    double edges = 0.0;
    for (std::size_t s = 0; s < painted.size(); ++s)
        for (const auto& c : painted[s].triangles) {
            const osg::Vec3d corners[] = {
                {c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]}};
            Triangle triangle{.corner = corners[0],
                              .first = corners[1] - corners[0],
                              .second = corners[2] - corners[0],
                              .normal = (corners[1] - corners[0]) ^ (corners[2] - corners[0]),
                              .surface = static_cast<int>(s)};
            triangle.area = triangle.normal.normalize() / 2.0;
            edges += std::max(triangle.first.length(), triangle.second.length());
            for (const osg::Vec3d& corner : corners)
                for (int axis = 0; axis < 3; ++axis) {
                    low[axis] = std::min(low[axis], corner[axis]);
                    high[axis] = std::max(high[axis], corner[axis]);
                }
            triangles_.push_back(triangle);
        }
    if (triangles_.empty())
        return;
    const double diagonal = (high - low).length();
    tolerance_ = toleranceOfDiagonal * diagonal;
    low_ = low - osg::Vec3d(2, 2, 2) * tolerance_;
    cell_ = std::max({edges / static_cast<double>(triangles_.size()), diagonal / 512.0, 1e-300});
    const osg::Vec3d margin = osg::Vec3d(1, 1, 1) * tolerance_;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const Triangle& t = triangles_[i];
        osg::Vec3d from = t.corner, to = t.corner;
        for (const osg::Vec3d& other : {t.corner + t.first, t.corner + t.second})
            for (int axis = 0; axis < 3; ++axis) {
                from[axis] = std::min(from[axis], other[axis]);
                to[axis] = std::max(to[axis], other[axis]);
            }
        from -= margin, to += margin;
        const auto at = [&](double value, int axis) { return place((value - low_[axis]) / cell_); };
        for (auto x = at(from.x(), 0); x <= at(to.x(), 0); ++x)
            for (auto y = at(from.y(), 1); y <= at(to.y(), 1); ++y)
                for (auto z = at(from.z(), 2); z <= at(to.z(), 2); ++z)
                    cells_[(x << 40) | (y << 20) | z].push_back(static_cast<unsigned int>(i));
    }
}

std::uint64_t PaintedGrid::cellOf(const osg::Vec3d& point) const {
    const osg::Vec3d from = (point - low_) / cell_;
    return (place(from.x()) << 40) | (place(from.y()) << 20) | place(from.z());
}

PaintedGrid::Fit PaintedGrid::fitOf(const Triangle& t, const osg::Vec3d& point,
                                    const osg::Vec3d& normal) const {
    const osg::Vec3d from = point - t.corner;
    const double off = std::abs(from * t.normal);
    if (t.normal * normal < leastFacing || off > tolerance_ || t.area <= 0.0)
        return Fit::none;
    // How far outside of its sides: their lengths times these are areas.
    const double b = (from ^ t.second) * t.normal, c = (t.first ^ from) * t.normal;
    const double outside = std::max({-b / t.second.length(), -c / t.first.length(),
                                     (b + c - 2.0 * t.area) / (t.second - t.first).length()});
    if (outside > tolerance_)
        return Fit::none;
    return std::max(off, outside) <= exactPart * tolerance_ ? Fit::exact : Fit::near;
}

std::vector<unsigned int> PaintedGrid::holding(const osg::Vec3d& point,
                                               const osg::Vec3d& normal) const {
    std::vector<unsigned int> found;
    const auto cell = cells_.find(cellOf(point));
    if (cell == cells_.end())
        return found;
    Fit best = Fit::near;
    for (const unsigned int i : cell->second) {
        const Fit fit = fitOf(triangles_[i], point, normal);
        if (fit > best) {
            best = fit;
            found.clear();
        }
        if (fit == best)
            found.push_back(i);
    }
    return found;
}

int PaintedGrid::find(const osg::Vec3d& point, const osg::Vec3d& normal) const {
    int surface = -1;
    for (const unsigned int i : holding(point, normal))
        surface = std::max(surface, triangles_[i].surface);
    return surface;
}

} // namespace irsg
