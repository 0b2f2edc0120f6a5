#include "irsg/geometry/model/ModelPlacing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/geometry/conversion/GeometryCollector.h"
#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/conversion/OsgValues.h"
#include "irsg/geometry/model/TailSearch.h"
#include "irsg/geometry/reading/NoFaces.h"

namespace irsg {
namespace {

constexpr double leastUnit_m = 1e-6, greatestUnit_m = 1e6;
/// How long the things are that one models.
constexpr double shortest_m = 0.5, longest_m = 500.0;

const std::string& nameOf(ModelAxis axis) {
    return modelAxisNames()[static_cast<std::size_t>(axis)];
}

int lineOf(ModelAxis axis) {
    return static_cast<int>(axis) / 2;
}

bool isNegative(ModelAxis axis) {
    return static_cast<int>(axis) % 2 == 1;
}

ModelAxis axisAlong(int line, bool negative = false) {
    return static_cast<ModelAxis>(2 * line + (negative ? 1 : 0));
}

osg::Vec3d directionOf(ModelAxis axis) {
    osg::Vec3d direction;
    direction[lineOf(axis)] = isNegative(axis) ? -1.0 : 1.0;
    return direction;
}

std::string shown(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

/// How much of a model lies where, seen along one axis of the file: the area at each height.
class Profile {
  public:
    static constexpr std::size_t bins = 64;

    Profile(const SurfaceMesh& mesh, const BoundingBox& box, int line) {
        const std::array<double, 3> from = {box.min.x, box.min.y, box.min.z},
                                    to = {box.max.x, box.max.y, box.max.z};
        const double first = from[static_cast<std::size_t>(line)],
                     extent = to[static_cast<std::size_t>(line)] - first;
        for (const auto& [kind, part] : mesh.parts())
            for (std::size_t i = 0; i + 2 < part.triangles.size(); i += 3) {
                const auto corner = [&](std::size_t k) {
                    return osg::Vec3d(toOsg(part.vertices[part.triangles[i + k]]));
                };
                const osg::Vec3d a = corner(0), b = corner(1), c = corner(2);
                const double area = ((b - a) ^ (c - a)).length() / 2.0;
                const double at = ((a + b + c)[line] / 3.0 - first) / std::max(extent, 1e-300);
                // Between the bins on its both sides, so that what is symmetric stays so.
                const double place = std::clamp(at * bins - 0.5, 0.0, bins - 1.0);
                const auto low = std::min(bins - 2, static_cast<std::size_t>(place));
                const double rest = place - static_cast<double>(low);
                area_[low] += area * (1.0 - rest);
                area_[low + 1] += area * rest;
                sum_ += area;
            }
    }
    /// 0 for what is its own mirror image, 1 for what shares nothing with it.
    double asymmetry() const {
        double difference = 0.0;
        for (std::size_t i = 0; i < bins; ++i)
            difference += std::abs(smooth(i) - smooth(bins - 1 - i));
        return sum_ > 0.0 ? difference / (2.0 * sum_) : 0.0;
    }

  private:
    /// Facets are assigned to a bin whole: neighbours share.
    double smooth(std::size_t i) const {
        return 0.5 * area_[i] + 0.25 * area_[i == 0 ? 0 : i - 1] +
               0.25 * area_[i + 1 == bins ? bins - 1 : i + 1];
    }
    std::array<double, bins> area_{};
    double sum_ = 0.0;
};

double along(const Vec3& v, int line) {
    return line == 0 ? v.x : line == 1 ? v.y : v.z;
}

SurfaceMesh asInFile(const LoadedGraph& graph, const std::string& file) {
    SurfaceMesh mesh;
    GeometryCollector(mesh, {}, file, {.forceTwoSided = true}).collect(*graph.node);
    return mesh;
}

PlacingGuess guessOf(const SurfaceMesh& mesh, const LoadedGraph& graph, const std::string& file) {
    const FileAxes& axes = graph.axes;
    BoundingBox box = BoundingBox::nowhere();
    for (const auto& [kind, part] : mesh.parts())
        box.include(part.bounds);
    if (!box.valid())
        refuseWithoutFaces(file, graph.remarks);
    const Vec3 size = box.max - box.min;
    PlacingGuess guess;
    ModelPlacing& placing = guess.placing;

    std::array<double, 3> asymmetry{};
    for (int line = 0; line < 3; ++line)
        asymmetry[static_cast<std::size_t>(line)] = Profile(mesh, box, line).asymmetry();
    const auto least =
        static_cast<int>(std::min_element(asymmetry.begin(), asymmetry.end()) - asymmetry.begin());
    const int second = (least + 1) % 3, third = (least + 2) % 3;
    const bool tells = asymmetry[static_cast<std::size_t>(least)] < 0.02 &&
                       3.0 * asymmetry[static_cast<std::size_t>(least)] <
                           std::min(asymmetry[static_cast<std::size_t>(second)],
                                    asymmetry[static_cast<std::size_t>(third)]);

    if (!axes.reason.empty())
        guess.reasons.push_back(axes.reason);
    if (axes.up) {
        placing.up = axes.up;
        guess.reasons.push_back("up is " + nameOf(*axes.up) + ", as stated");
    } else if (tells) {
        const int lower = along(size, second) < along(size, third) ? second : third;
        placing.up = axisAlong(lower);
        guess.reasons.push_back("up is " + nameOf(*placing.up) +
                                ": the model is its own mirror image along " +
                                nameOf(axisAlong(least)).substr(1) + " and lower than it is long");
    } else {
        placing.up = ModelAxis::plusZ;
        guess.reasons.push_back("up is +z: neither the file nor the shape tells");
    }

    const int upLine = lineOf(*placing.up);
    int noseLine = upLine == 1 ? 2 : 1;
    if (axes.front && lineOf(*axes.front) != upLine) {
        placing.nose = axes.front;
        guess.reasons.push_back("the nose points along " + nameOf(*axes.front) + ", as stated");
    } else {
        const int one = (upLine + 1) % 3, other = (upLine + 2) % 3;
        const double first = asymmetry[static_cast<std::size_t>(one)],
                     last = asymmetry[static_cast<std::size_t>(other)];
        std::string why = "neither the file nor the shape tells";
        bool isTold = true;
        if (std::min(first, last) < 0.02 && 3.0 * std::min(first, last) < std::max(first, last)) {
            noseLine = first < last ? other : one;
            why = "the model is its own mirror image across it";
        } else if (std::min(first, last) < 0.15 &&
                   2.0 * std::min(first, last) < std::max(first, last)) {
            // Doors, pitot tubes and pilots stand on one side; wings are longer than hulls.
            noseLine = first < last ? other : one;
            why = "the model is nearly its own mirror image across it";
        } else if (std::max(along(size, one), along(size, other)) >
                   1.2 * std::min(along(size, one), along(size, other))) {
            noseLine = along(size, one) > along(size, other) ? one : other;
            why = "the model is longest along it";
        } else {
            isTold = false;
        }
        if (!isTold && axes.usualFront && lineOf(*axes.usualFront) != upLine)
            noseLine = lineOf(*axes.usualFront);
        const double tail = tailTowards(mesh, box, noseLine, upLine, isNegative(*placing.up));
        bool backwards = tail > 0.02;
        if (std::abs(tail) > 0.02) {
            why += ", and its other end is higher, wider or has a fin, as a tail does";
        } else if (axes.usualFront && lineOf(*axes.usualFront) == noseLine) {
            backwards = isNegative(*axes.usualFront);
            why += ", and as in most models of its format";
        }
        placing.nose = axisAlong(noseLine, backwards);
        guess.reasons.push_back("the nose points along " + nameOf(*placing.nose) + ": " + why);
    }

    const double longest = std::max({size.x, size.y, size.z});
    const auto isLikely = [&](double unit_m) {
        return longest * unit_m >= shortest_m && longest * unit_m <= longest_m;
    };
    const auto likely = std::ranges::find_if(modelUnits, isLikely, &ModelUnit::unit_m);
    const bool spoken = !axes.unit_m && axes.spokenUnit && isLikely(axes.spokenUnit->unit_m);
    const double stated_m = axes.unit_m ? *axes.unit_m : spoken ? axes.spokenUnit->unit_m : 1.0;
    // Files are often not in the unit that their format has.
    placing.unit_m =
        isLikely(stated_m) || likely == std::end(modelUnits) ? stated_m : likely->unit_m;
    const std::string so = "so it is " + shown(longest * *placing.unit_m) + " m long";
    if (spoken)
        guess.reasons.push_back("it is in " + unitName(stated_m) +
                                ", as a comment or a name in the "
                                "file says (\"" +
                                axes.spokenUnit->words + "\"): " + so);
    else if (!axes.unit_m)
        guess.reasons.push_back("it is in " + unitName(*placing.unit_m) + ": " + so);
    else if (*placing.unit_m == stated_m)
        guess.reasons.push_back("it is in " + unitName(stated_m) + ", as stated: " + so);
    else
        guess.reasons.push_back("it is in " + unitName(*placing.unit_m) +
                                ", not as stated: it would be " + shown(longest * stated_m) +
                                " m long; " + so);

    const double off = length(box.centre()), half = 0.5 * length(size);
    placing.origin = ModelOrigin{off > half ? ModelOrigin::At::centre : ModelOrigin::At::file, {}};
    guess.reasons.push_back(off > half
                                ? "its origin is its centre: that of the file lies outside of it"
                                : "its origin is that of the file");
    const int starboardLine = 3 - upLine - lineOf(*placing.nose);
    guess.size_m =
        Vec3{along(size, starboardLine), along(size, lineOf(*placing.nose)), along(size, upLine)} *
        *placing.unit_m;
    return guess;
}

} // namespace

std::string unitName(double unit_m) {
    for (const ModelUnit& unit : modelUnits)
        if (std::abs(unit.unit_m - unit_m) < 1e-9 * unit_m)
            return unit.name;
    return "units of " + shown(unit_m) + " m";
}

const std::vector<std::string>& modelAxisNames() {
    static const std::vector<std::string> names = {"+x", "-x", "+y", "-y", "+z", "-z"};
    return names;
}

ModelPlacing completed(const ModelPlacing& placing, const FileAxes& axes, const std::string& file) {
    ModelPlacing whole = placing;
    whole.up = placing.up ? placing.up : axes.up ? axes.up : ModelAxis::plusZ;
    if (!whole.nose) {
        // What is stated belongs together: a nose along another up would be no statement.
        const bool upright = lineOf(*whole.up) != lineOf(ModelAxis::plusY);
        const std::optional<ModelAxis>& front = axes.front ? axes.front : axes.usualFront;
        whole.nose = front && lineOf(*front) != lineOf(*whole.up) ? *front
                     : upright                                    ? ModelAxis::plusY
                                                                  : ModelAxis::plusZ;
    }
    if (lineOf(*whole.nose) == lineOf(*whole.up))
        throw InputError({file, "noseAxis",
                          nameOf(*whole.nose) + " with " + nameOf(*whole.up) + " up",
                          "a nose that does not point up or down"});
    whole.unit_m = placing.unit_m ? placing.unit_m : axes.unit_m ? axes.unit_m : 1.0;
    if (!(*whole.unit_m >= leastUnit_m && *whole.unit_m <= greatestUnit_m))
        throw InputError({file, "unit_m", shown(*whole.unit_m), "metres from 1e-6 to 1e6"});
    return whole;
}

Matrix4 turnAndScale(const ModelPlacing& completed) {
    const osg::Vec3d nose = directionOf(*completed.nose), up = directionOf(*completed.up),
                     starboard = nose ^ up;
    const double unit_m = *completed.unit_m;
    Matrix4 matrix;
    for (int row = 0; row < 3; ++row) {
        auto& [x, y, z, last] = matrix.rows[static_cast<std::size_t>(row)];
        x = starboard[row] * unit_m;
        y = nose[row] * unit_m;
        z = up[row] * unit_m;
    }
    return matrix;
}

PlacingGuess guessPlacing(const LoadedGraph& graph, const std::string& file) {
    return guessOf(asInFile(graph, file), graph, file);
}

PlacingGuess placingGuess(const std::filesystem::path& file) {
    return guessPlacing(loadGraph(file, LoadPurpose::infrared), file.string());
}

ModelShape shapeOf(const std::filesystem::path& file) {
    const LoadedGraph loaded = loadGraph(file, LoadPurpose::infrared);
    const SurfaceMesh mesh = asInFile(loaded, file.string());
    ModelShape shape;
    shape.axes = loaded.axes;
    shape.guess = guessOf(mesh, loaded, file.string());
    for (const auto& [kind, part] : mesh.parts())
        for (const unsigned int index : part.triangles)
            shape.corners.push_back(part.vertices[index]);
    return shape;
}

} // namespace irsg
