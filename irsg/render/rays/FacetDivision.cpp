#include "irsg/render/rays/FacetDivision.h"

#include <algorithm>
#include <cmath>

namespace irsg {

namespace {

double crossed(const FacetPlace& a, const FacetPlace& b) {
    return a.u * b.v - a.v * b.u;
}
double lengthOf(const FacetPlace& a) {
    return std::sqrt(a.u * a.u + a.v * a.v);
}
/// Of a place to the left of a line, as a length of weights.
double leftOf(const FacetDivision::Line& line, const FacetPlace& place) {
    const FacetPlace along = line.to - line.from;
    return crossed(along, place - line.from) / lengthOf(along);
}

} // namespace

FacetDivision::FacetDivision(const std::vector<Line>& walls, double tolerance)
    : tolerance_(tolerance) {
    cells_.push_back({whole, 0});
    slots_.emplace_back(-1, 0);
    for (const Line& wall : walls)
        for (std::size_t i = cells_.size(); i-- > 0 && cells_.size() < mostParts;)
            cut(static_cast<std::uint32_t>(i), wall);
    for (std::uint32_t i = 0; i < cells_.size(); ++i) {
        cells_[i].part = i;
        Part& part = parts_.emplace_back();
        part.corners = cells_[i].corners;
        for (const Line& wall : walls) {
            Line touching = wall;
            if (clip(touching, part.corners, 2.0 * tolerance_))
                part.walls.push_back(wall);
        }
    }
}

bool FacetDivision::clip(Line& line, const Triangle& triangle, double margin) {
    double from = 0.0, to = 1.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Line edge{triangle[i], triangle[(i + 1) % 3]};
        const double atFrom = leftOf(edge, line.from) + margin;
        const double atTo = leftOf(edge, line.to) + margin;
        if (atFrom < 0.0 && atTo < 0.0)
            return false;
        if (atFrom < 0.0)
            from = std::max(from, atFrom / (atFrom - atTo));
        else if (atTo < 0.0)
            to = std::min(to, atFrom / (atFrom - atTo));
    }
    if (!(from < to))
        return false;
    const FacetPlace along = line.to - line.from;
    line.to = line.from + along * to;
    line.from = line.from + along * from;
    return true;
}

void FacetDivision::cut(std::uint32_t cell, const Line& wall) {
    const Triangle corners = cells_[cell].corners;
    Line inside = wall;
    if (!clip(inside, corners, -tolerance_) || lengthOf(inside.to - inside.from) < tolerance_)
        return;
    std::array<double, 3> left{};
    std::size_t lone = 3, on = 3;
    int ahead = 0, behind = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        left[i] = leftOf(wall, corners[i]);
        if (std::abs(left[i]) < 0.5 * tolerance_)
            on = i;
        else
            ++(left[i] > 0.0 ? ahead : behind);
    }
    if (ahead == 0 || behind == 0)
        return;
    const auto between = [&](std::size_t i, std::size_t k) {
        return corners[i] + (corners[k] - corners[i]) * (left[i] / (left[i] - left[k]));
    };
    if (on != 3) {
        const std::size_t next = (on + 1) % 3, last = (on + 2) % 3;
        const FacetPlace place = between(next, last);
        split(cell, {corners[on], place}, {corners[on], place, corners[last]},
              {corners[on], corners[next], place});
        return;
    }
    for (std::size_t i = 0; i < 3; ++i)
        if ((left[i] > 0.0) == (ahead == 1))
            lone = i;
    const std::size_t next = (lone + 1) % 3, last = (lone + 2) % 3;
    const FacetPlace toNext = between(lone, next), toLast = between(lone, last);
    // The lone corner is cut off; the rest is cut along its diagonal.
    split(cell, {toNext, toLast}, {corners[lone], toNext, toLast}, {toNext, corners[next], toLast});
    const auto rest = static_cast<std::uint32_t>(cells_.size() - 1);
    split(rest, {toLast, corners[next]}, {toLast, corners[next], corners[last]},
          {toNext, corners[next], toLast});
}

void FacetDivision::split(std::uint32_t cell, const Line& along, const Triangle& first,
                          const Triangle& second) {
    const FacetPlace way = along.to - along.from;
    Split made;
    made.a = -way.v;
    made.b = way.u;
    made.c = way.v * along.from.u - way.u * along.from.v;
    const auto other = static_cast<std::uint32_t>(cells_.size());
    made.branches = {-1 - static_cast<std::int32_t>(cell), -1 - static_cast<std::int32_t>(other)};
    const auto number = static_cast<std::int32_t>(splits_.size());
    const auto [parent, branch] = slots_[cell];
    (parent < 0 ? root_ : splits_[static_cast<std::size_t>(parent)].branches[branch]) = number;
    splits_.push_back(made);
    slots_[cell] = {number, 0};
    slots_.emplace_back(number, 1);
    cells_.push_back({second, cells_[cell].part});
    cells_[cell].corners = first;
}

bool FacetDivision::isBetween(std::uint32_t cell, const FacetPlace& from,
                              const FacetPlace& to) const {
    return std::ranges::any_of(parts_[cells_[cell].part].walls, [&](const Line& wall) {
        const double a = leftOf(wall, from), b = leftOf(wall, to);
        const double c = leftOf({from, to}, wall.from), d = leftOf({from, to}, wall.to);
        return a * b <= 0.0 && c * d <= 0.0;
    });
}

} // namespace irsg
