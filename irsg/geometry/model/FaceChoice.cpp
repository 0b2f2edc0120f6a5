#include "irsg/geometry/model/FaceChoice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace irsg {
namespace {

template <typename Wanted>
FaceNumbers those(const FaceMesh& mesh, const Wanted& wanted) {
    FaceNumbers found;
    for (unsigned int f = 0; f < mesh.faces().size(); ++f)
        if (wanted(mesh.faces()[f], f))
            found.push_back(f);
    return found;
}

/// Of the tenth of a millionth of the way that a ray takes: faces that coincide are one.
constexpr double sameOfConfiguration = 1e-7;
/// Of the diagonal: what lies behind by less is not hidden.
constexpr double behindOfDiagonal = 1e-4;
/// More pixels than a picture of a box is given.
constexpr double mostAcross = 4096.0;

/// Which face is seen in each pixel of a box.
class SeenFaces {
  public:
    SeenFaces(const FaceMesh& mesh, const FaceBox& box)
        : mesh_(mesh),
          box_(box),
          width_(pixels(box.right - box.left)),
          height_(pixels(box.bottom - box.top)),
          nearest_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0.0F),
          face_(nearest_.size(), none) {
        for (unsigned int f = 0; f < mesh.faces().size(); ++f) {
            const auto& face = mesh.faces()[f];
            if (!face.culled || looksHere(face))
                for (const auto& triangle : mesh.trianglesOf(face))
                    draw(triangle, f);
        }
    }
    bool looksHere(const FaceMesh::Face& face) const {
        return dot(face.normal, box_.eye - face.point) > 0.0;
    }
    /// Whether the middle of a face, which lies at (x, y) of the picture, is seen.
    bool isSeen(unsigned int number, double x, double y) const {
        const auto& face = mesh_.faces()[number];
        const bool here = looksHere(face);
        if (face.culled && !here)
            return false;
        const auto column = std::clamp(static_cast<int>(x - box_.left), 0, width_ - 1);
        const auto row = std::clamp(static_cast<int>(y - box_.top), 0, height_ - 1);
        const unsigned int before = face_[static_cast<std::size_t>(row * width_ + column)];
        if (before == number)
            return true;
        // A back is seen where no front is drawn, as in an open shell.
        if (!here && (before == none || looksHere(mesh_.faces()[before])))
            return false;
        if (before == none)
            return true;
        // By how much the middle lies behind the other one's plane. At the limb of a curved surface
        // neighbours share a pixel without hiding each other.
        const auto& other = mesh_.faces()[before];
        const double behind = dot(other.point - face.point, other.normal);
        const double slack = other.part == face.part ? 2.0 * pixelAt(face.point) : 0.0;
        return (looksHere(other) ? behind : -behind) < behindOfDiagonal * mesh_.diagonal() + slack;
    }

  private:
    static constexpr unsigned int none = ~0U;
    static int pixels(double length) {
        return static_cast<int>(std::ceil(std::clamp(length, 1.0, mostAcross)));
    }
    /// What a pixel is wide at a point, in the file's unit.
    double pixelAt(const Vec3& point) const {
        const Matrix4& m = box_.toPicture;
        const Vec3 across{m(0, 0), m(1, 0), m(2, 0)}, ahead{m(0, 3), m(1, 3), m(2, 3)};
        const double perUnit = length(across - ahead * (dot(across, ahead) / dot(ahead, ahead)));
        return (dot(point, ahead) + m(3, 3)) / perUnit;
    }
    void draw(const FaceMesh::Triangle& triangle, unsigned int number) {
        std::array<Vec3, 3> at; // x and y in the box, 1 / depth
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [px, py, pz, w] = box_.toPicture.homogeneous(triangle[k]);
            if (w <= 0.0)
                return;
            at[k] = {px / w - box_.left, py / w - box_.top, 1.0 / w};
        }
        const double area = turn(at[0], at[1], at[2]);
        if (area == 0.0)
            return;
        const auto [lowX, highX] = std::minmax({at[0].x, at[1].x, at[2].x});
        const auto [lowY, highY] = std::minmax({at[0].y, at[1].y, at[2].y});
        const int firstX = std::max(0, static_cast<int>(std::ceil(std::max(lowX, 0.0) - 0.5))),
                  lastX = static_cast<int>(std::floor(std::min(highX, width_ + 0.0) - 0.5));
        const int firstY = std::max(0, static_cast<int>(std::ceil(std::max(lowY, 0.0) - 0.5))),
                  lastY = static_cast<int>(std::floor(std::min(highY, height_ + 0.0) - 0.5));
        for (int y = firstY; y <= std::min(lastY, height_ - 1); ++y)
            for (int x = firstX; x <= std::min(lastX, width_ - 1); ++x) {
                const Vec3 p{x + 0.5, y + 0.5, 0.0};
                const double a = turn(at[1], at[2], p) / area, b = turn(at[2], at[0], p) / area,
                             c = 1.0 - a - b;
                if (a < 0.0 || b < 0.0 || c < 0.0)
                    continue;
                // 1 / depth is linear in the picture.
                const auto near = static_cast<float>(a * at[0].z + b * at[1].z + c * at[2].z);
                const auto pixel = static_cast<std::size_t>(y * width_ + x);
                if (near > nearest_[pixel]) {
                    nearest_[pixel] = near;
                    face_[pixel] = number;
                }
            }
    }
    static double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    }

    const FaceMesh& mesh_;
    const FaceBox& box_;
    int width_, height_;
    std::vector<float> nearest_;
    std::vector<unsigned int> face_;
};

} // namespace

FaceNumbers chosen(const FaceNumbers& before, const FaceNumbers& more, Choosing how) {
    if (how == Choosing::anew)
        return more;
    FaceNumbers both;
    if (how == Choosing::add)
        std::ranges::set_union(before, more, std::back_inserter(both));
    else
        std::ranges::set_difference(before, more, std::back_inserter(both));
    return both;
}

std::optional<unsigned int> faceAlong(const FaceMesh& mesh, const Vec3& eye,
                                      const Vec3& direction) {
    std::optional<unsigned int> found;
    double nearest = HUGE_VAL;
    bool looksAway = false;
    for (unsigned int f = 0; f < mesh.faces().size(); ++f)
        for (const auto& [a, b, c] : mesh.trianglesOf(mesh.faces()[f])) {
            // Möller and Trumbore: where the ray meets the plane, and where in the triangle.
            const Vec3 first = b - a, second = c - a;
            const Vec3 p = cross(direction, second);
            const double turn = dot(first, p);
            if (turn == 0.0 || (turn < 0.0 && mesh.faces()[f].culled))
                continue;
            const Vec3 from = eye - a;
            const double u = dot(from, p) / turn;
            if (u < 0.0 || u > 1.0)
                continue;
            const Vec3 q = cross(from, first);
            const double v = dot(direction, q) / turn;
            if (v < 0.0 || u + v > 1.0)
                continue;
            const double way = dot(second, q) / turn;
            if (way <= 0.0)
                continue;
            // Of two that coincide, it is the one that looks here.
            const bool isNearer =
                way < nearest * (1.0 - sameOfConfiguration) ||
                (looksAway && turn > 0.0 && way <= nearest * (1.0 + sameOfConfiguration));
            if (!isNearer)
                continue;
            nearest = way;
            found = f;
            looksAway = turn < 0.0;
        }
    return found;
}

FaceNumbers partOf(const FaceMesh& mesh, unsigned int face) {
    const unsigned int part = mesh.faces().at(face).part;
    return those(mesh, [&](const FaceMesh::Face& one, unsigned int) { return one.part == part; });
}

FaceNumbers sameMaterialAs(const FaceMesh& mesh, unsigned int face) {
    const unsigned int material = mesh.faces().at(face).material;
    return those(mesh,
                 [&](const FaceMesh::Face& one, unsigned int) { return one.material == material; });
}

FaceNumbers smoothFrom(const FaceMesh& mesh, unsigned int face, double most_rad) {
    // A hair above, so that faces at just that angle are reached.
    const double least = std::cos(std::min(most_rad + 1e-6, std::numbers::pi));
    std::vector<bool> reached(mesh.faces().size());
    std::vector<unsigned int> open{face};
    reached.at(face) = true;
    while (!open.empty()) {
        const unsigned int from = open.back();
        open.pop_back();
        for (const auto& neighbour : mesh.neighboursOf(from)) {
            const double cosine =
                dot(mesh.faces()[from].normal, mesh.faces()[neighbour.face].normal);
            if (reached[neighbour.face] || (neighbour.opposed ? -cosine : cosine) < least)
                continue;
            reached[neighbour.face] = true;
            open.push_back(neighbour.face);
        }
    }
    return those(mesh, [&](const FaceMesh::Face&, unsigned int f) { return bool(reached[f]); });
}

FaceNumbers facesIn(const FaceMesh& mesh, const FaceBox& box) {
    const auto all = [](const FaceMesh::Face&, unsigned int, double, double) { return true; };
    const auto within = [&](const auto& wanted) {
        return those(mesh, [&](const FaceMesh::Face& face, unsigned int f) {
            const auto [px, py, pz, w] = box.toPicture.homogeneous(face.point);
            const double x = px / w, y = py / w;
            return w > 0.0 && x >= box.left && x <= box.right && y >= box.top && y <= box.bottom &&
                   wanted(face, f, x, y);
        });
    };
    if (box.hiddenToo)
        return within(all);
    const SeenFaces seen(mesh, box);
    return within([&](const FaceMesh::Face&, unsigned int f, double x, double y) {
        return seen.isSeen(f, x, y);
    });
}

} // namespace irsg
