#include "tools/samples/Patch.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "irsg/core/Interpolation.h"

namespace smat {

using irsg::Vec3;

Curve::Curve(std::initializer_list<Knot> knots) : knots_(knots), slopes_(knots.size(), 0.0) {
    const auto secant = [&](std::size_t i) {
        return (knots_[i + 1].y - knots_[i].y) / (knots_[i + 1].x - knots_[i].x);
    };
    const std::size_t last = knots_.size() - 1;
    slopes_[0] = secant(0);
    slopes_[last] = secant(last - 1);
    for (std::size_t i = 1; i < last; ++i) {
        const double before = secant(i - 1), after = secant(i);
        // The harmonic mean keeps the curve between its knots.
        slopes_[i] = before * after > 0.0 ? 2.0 * before * after / (before + after) : 0.0;
    }
}

double Curve::operator()(double x) const {
    const auto [i, k, t] = irsg::bracket(knots_, x, irsg::Beyond::clamp, &Knot::x);
    const double width = knots_[k].x - knots_[i].x;
    const double t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * knots_[i].y + (t3 - 2 * t2 + t) * width * slopes_[i] +
           (-2 * t3 + 3 * t2) * knots_[k].y + (t3 - t2) * width * slopes_[k];
}

std::vector<double> edges(double first, double last, double step, std::span<const double> marks) {
    std::vector<double> fixed{first, last};
    for (const double mark : marks)
        if (mark > first && mark < last)
            fixed.push_back(mark);
    std::ranges::sort(fixed);
    std::vector<double> all;
    for (std::size_t i = 0; i + 1 < fixed.size(); ++i) {
        const double width = fixed[i + 1] - fixed[i];
        if (width < 1e-9)
            continue;
        const int cells = std::max(1, static_cast<int>(std::lround(width / step)));
        for (int k = 0; k < cells; ++k)
            all.push_back(fixed[i] + width * k / cells);
    }
    all.push_back(last);
    return all;
}

std::vector<double> roundedEdges(double first, double last, int cells) {
    std::vector<double> all;
    for (int i = 0; i <= cells; ++i)
        all.push_back(first +
                      (last - first) * 0.5 * (1.0 - std::cos(std::numbers::pi * i / cells)));
    return all;
}

namespace {

/// The normal of a surface; where its lines meet in a point, that of a place beside it.
Vec3 normalOf(const Shape& shape, double u, double v, double uSpan, double vSpan, double uMiddle) {
    const double du = 1e-4 * uSpan, dv = 1e-4 * vSpan;
    for (const double inwards : {0.0, 0.01, 0.05}) {
        const double at = u + inwards * (uMiddle - u);
        const Vec3 normal =
            cross(shape(at + du, v) - shape(at - du, v), shape(at, v + dv) - shape(at, v - dv));
        if (length(normal) > 1e-12)
            return normalized(normal);
    }
    return {0, 0, 1};
}

/// The corners of a cell that are not where the one before them is.
std::vector<std::size_t> distinct(const std::vector<FlightVertex>& vertices,
                                  std::span<const std::size_t> corners) {
    constexpr double nothing_m = 1e-6;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3& here = vertices[corners[i]].position;
        const Vec3& before = vertices[corners[(i + corners.size() - 1) % corners.size()]].position;
        if (length(here - before) > nothing_m)
            kept.push_back(corners[i]);
    }
    return kept;
}

} // namespace

void addPatch(ModelWriter& writer, const Shape& shape, std::span<const double> us,
              std::span<const double> vs, const SurfaceAt& surfaceAt) {
    const double uSpan = us.back() - us.front(), vSpan = vs.back() - vs.front();
    const double uMiddle = 0.5 * (us.front() + us.back());
    std::vector<FlightVertex> vertices;
    for (const double u : us)
        for (const double v : vs)
            vertices.push_back({shape(u, v), normalOf(shape, u, v, uSpan, vSpan, uMiddle)});

    struct Part {
        std::vector<FlightVertex> vertices;
        std::map<std::size_t, std::uint32_t> known;
        std::vector<FlightPrimitive> strips;
        /// The index of a vertex of the patch among those of the part.
        std::uint32_t index(std::size_t vertex, const std::vector<FlightVertex>& all) {
            const auto [place, isNew] =
                known.try_emplace(vertex, static_cast<std::uint32_t>(vertices.size()));
            if (isNew)
                vertices.push_back(all[vertex]);
            return place->second;
        }
    };
    std::vector<std::pair<const FlightSurface*, Part>> parts;
    const auto partOf = [&](const FlightSurface* surface) -> Part& {
        const auto found =
            std::ranges::find(parts, surface, &std::pair<const FlightSurface*, Part>::first);
        return found != parts.end() ? found->second : parts.emplace_back(surface, Part()).second;
    };
    const std::size_t columns = vs.size();
    for (std::size_t i = 0; i + 1 < us.size(); ++i) {
        const FlightSurface* last = nullptr;
        for (std::size_t k = 0; k + 1 < columns; ++k) {
            const auto* const surface =
                surfaceAt(0.5 * (us[i] + us[i + 1]), 0.5 * (vs[k] + vs[k + 1]));
            if (surface == nullptr) {
                last = nullptr;
                continue;
            }
            Part& part = partOf(surface);
            const std::size_t corners[] = {i * columns + k, (i + 1) * columns + k,
                                           (i + 1) * columns + k + 1, i * columns + k + 1};
            if (const auto triangle = distinct(vertices, corners); triangle.size() < 4) {
                // Where lines meet in a point a cell is a triangle, or nothing.
                if (triangle.size() == 3) {
                    auto& strip = part.strips.emplace_back().indices;
                    for (const std::size_t corner : triangle)
                        strip.push_back(part.index(corner, vertices));
                }
                last = nullptr;
                continue;
            }
            if (surface != last) {
                part.strips.push_back(
                    {FlightPrimitive::Kind::strip,
                     {part.index(corners[0], vertices), part.index(corners[1], vertices)}});
            }
            auto& strip = part.strips.back().indices;
            strip.push_back(part.index(corners[3], vertices));
            strip.push_back(part.index(corners[2], vertices));
            last = surface;
        }
    }
    for (auto& [surface, part] : parts)
        writer.addMesh(*surface, part.vertices, part.strips);
}

void addPatch(ModelWriter& writer, const Shape& shape, std::span<const double> us,
              std::span<const double> vs, const FlightSurface& surface) {
    addPatch(writer, shape, us, vs, [&](double, double) { return &surface; });
}

void addEllipsoid(ModelWriter& writer, const Vec3& centre, const Vec3& radii,
                  const FlightSurface& surface, int rings, int segments) {
    constexpr double pi = std::numbers::pi;
    const auto shape = [&](double u, double v) {
        return centre + Vec3{radii.x * std::sin(u) * std::sin(v), radii.y * std::cos(u),
                             radii.z * std::sin(u) * std::cos(v)};
    };
    addPatch(writer, shape, edges(0.0, pi, pi / rings), edges(0.0, 2.0 * pi, 2.0 * pi / segments),
             surface);
}

} // namespace smat
