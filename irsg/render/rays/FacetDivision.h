#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace irsg {

/// A place in the plane of a facet, as weights of its second and third corner.
struct FacetPlace {
    double u = 0.0, v = 0.0;

    FacetPlace operator+(const FacetPlace& o) const { return {u + o.u, v + o.v}; }
    FacetPlace operator-(const FacetPlace& o) const { return {u - o.u, v - o.v}; }
    FacetPlace operator*(double s) const { return {u * s, v * s}; }
};

/// One side of a facet, divided into triangles by straight lines: along those where other facets
/// stand on it, so that no triangle lies on both sides of a wall, and then where it is to be
/// resolved. A tree of lines finds the triangle of a place.
class FacetDivision {
  public:
    /// Counter-clockwise as the facet's corners are.
    using Triangle = std::array<FacetPlace, 3>;
    struct Line {
        FacetPlace from, to;
    };
    /// The facet itself.
    static constexpr Triangle whole{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}};
    /// A triangle between walls, of which all cells are parts.
    struct Part {
        Triangle corners;
        std::vector<Line> walls; ///< those that touch it
    };
    struct Cell {
        Triangle corners;
        std::uint32_t part = 0;
    };
    /// Places where a u + b v + c is not negative belong to the first branch, the others to the
    /// second: another split, or -1 - its number for a cell.
    struct Split {
        double a = 0.0, b = 0.0, c = 0.0;
        std::array<std::int32_t, 2> branches{};
    };

    /// `tolerance`: in weights; what is nearer counts as being at the same place.
    FacetDivision(const std::vector<Line>& walls, double tolerance);

    const std::vector<Part>& parts() const { return parts_; }
    /// Cuts triangles in halves across their longest edges while isTooLarge(part, triangle) holds.
    /// `lengthOf` an edge.
    template <typename IsTooLarge, typename LengthOf>
    void refine(IsTooLarge isTooLarge, LengthOf lengthOf) {
        // Halves come behind: they are looked at in their turn.
        for (std::uint32_t i = 0; i < cells_.size(); ++i)
            while (isTooLarge(cells_[i].part, cells_[i].corners)) {
                const Triangle corners = cells_[i].corners;
                const std::size_t edge = longestOf(corners, lengthOf);
                const std::array<Triangle, 2> halves = halvesAcross(corners, edge);
                split(i, {corners[(edge + 2) % 3], halves[0][1]}, halves[0], halves[1]);
            }
    }
    /// The halves of a triangle.
    template <typename LengthOf>
    static std::array<Triangle, 2> halvesOf(const Triangle& corners, LengthOf lengthOf) {
        return halvesAcross(corners, longestOf(corners, lengthOf));
    }

    const std::vector<Cell>& cells() const { return cells_; }
    /// The first split, or -1 - the number of the only cell.
    std::int32_t root() const { return root_; }
    const std::vector<Split>& splits() const { return splits_; }
    std::uint32_t cellOf(const FacetPlace& place) const { return cellOf(place, root_, splits_); }
    /// The same of splits that are kept elsewhere, from the first of a side on.
    static std::uint32_t cellOf(const FacetPlace& place, std::int32_t root,
                                const std::vector<Split>& splits) {
        std::int32_t at = root;
        while (at >= 0) {
            const Split& one = splits[static_cast<std::size_t>(at)];
            at = one.branches[one.a * place.u + one.b * place.v + one.c >= 0.0 ? 0 : 1];
        }
        return static_cast<std::uint32_t>(-1 - at);
    }
    double tolerance() const { return tolerance_; }
    /// Whether a wall of a cell's part crosses the way between two places.
    bool isBetween(std::uint32_t cell, const FacetPlace& from, const FacetPlace& to) const;

    /// The part of a line in a triangle that is wider by `margin` on each side, none where it has
    /// no length.
    static bool clip(Line& line, const Triangle& triangle, double margin);

  private:
    static constexpr std::size_t mostParts = 1024;

    template <typename LengthOf>
    static std::size_t longestOf(const Triangle& corners, LengthOf lengthOf) {
        std::size_t longest = 0;
        double most = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double own = lengthOf(corners[i], corners[(i + 1) % 3]);
            if (own > most) {
                most = own;
                longest = i;
            }
        }
        return longest;
    }
    /// Across the edge that begins at a corner: first the half that has its end.
    static std::array<Triangle, 2> halvesAcross(const Triangle& corners, std::size_t edge) {
        const FacetPlace &from = corners[edge], &to = corners[(edge + 1) % 3],
                         &opposite = corners[(edge + 2) % 3];
        const FacetPlace middle = (from + to) * 0.5;
        return {{{opposite, middle, to}, {opposite, from, middle}}};
    }
    /// Cuts a cell along the line of a wall, if the wall goes through it.
    void cut(std::uint32_t cell, const Line& wall);
    /// Makes one of a cell's branch and another cell, which gets the number of the last.
    void split(std::uint32_t cell, const Line& along, const Triangle& first,
               const Triangle& second);

    double tolerance_;
    std::int32_t root_ = -1;
    std::vector<Split> splits_;
    std::vector<std::pair<std::int32_t, std::size_t>> slots_; ///< by cell: split and branch
    std::vector<Cell> cells_;
    std::vector<Part> parts_;
};

} // namespace irsg
