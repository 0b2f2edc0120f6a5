#include "irsg/radiance/GasLines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <random>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/core/RecentlyUsed.h"
#include "irsg/radiance/GasZones.h"

namespace irsg {

namespace {

constexpr std::size_t linesOfMesh = 576;

using Facet = std::array<Vec3, 3>;

/// Facets of a gas that lie close together.
struct FacetGroup {
    std::size_t gas = 0;
    BoundingSphere about;
    std::vector<Facet> facets;
};

std::vector<FacetGroup> groupsOf(const Mesh& mesh, const std::vector<IrCodes>& gases) {
    constexpr std::size_t together = 64; // of those that follow each other in the mesh
    std::vector<FacetGroup> groups;
    for (const Mesh::Part& part : mesh.parts) {
        const auto gas = std::ranges::find(gases, part.codes);
        if (gas == gases.end())
            continue;
        for (std::size_t i = 0; i + 2 < part.triangles.size(); i += 3) {
            if (i % (3 * together) == 0)
                groups.push_back({static_cast<std::size_t>(gas - gases.begin()), {}, {}});
            const auto at = [&](std::size_t k) {
                return toVec3(part.vertices[part.triangles[i + k]]);
            };
            groups.back().facets.push_back({at(0), at(1), at(2)});
        }
    }
    for (FacetGroup& group : groups) {
        BoundingBox box = BoundingBox::nowhere();
        for (const Facet& facet : group.facets)
            for (const Vec3& corner : facet)
                box.include(corner);
        group.about = {box.centre(), 0.5 * box.diagonal_m()};
    }
    return groups;
}

struct Crossing {
    double distance_m = 0.0;
    std::size_t gas = 0;
};

/// Where a line goes through facets, nearest first (T. Möller and B. Trumbore 1997, J. Graph. Tools
/// 2, 21).
std::vector<Crossing> crossings(const std::vector<FacetGroup>& groups, const Vec3& from,
                                const Vec3& along) {
    std::vector<Crossing> all;
    for (const FacetGroup& group : groups) {
        if (length(cross(group.about.centre_m - from, along)) > group.about.radius_m)
            continue;
        for (const Facet& facet : group.facets) {
            const Vec3 one = facet[1] - facet[0], other = facet[2] - facet[0];
            const Vec3 across = cross(along, other);
            const double determinant = dot(one, across);
            if (determinant == 0.0)
                continue;
            const Vec3 to = from - facet[0];
            const double u = dot(to, across) / determinant;
            const Vec3 turned = cross(to, one);
            const double v = dot(along, turned) / determinant;
            if (u >= 0.0 && v >= 0.0 && u + v <= 1.0)
                all.push_back({dot(other, turned) / determinant, group.gas});
        }
    }
    std::ranges::sort(all, {}, &Crossing::distance_m);
    return all;
}

/// Numbers that are the same on every machine.
class Chance {
  public:
    explicit Chance(std::uint64_t seed) : engine_(seed) {}
    double upTo1() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    template <typename Value>
    const Value& of(const std::vector<Value>& values) {
        return values[engine_() % values.size()];
    }

  private:
    std::mt19937_64 engine_;
};

class LineMaker {
  public:
    LineMaker(const std::shared_ptr<const Mesh>& mesh, const std::vector<IrCodes>& gases)
        : groups_(groupsOf(*mesh, gases)), ofGas_(gases.size()) {
        for (const IrCodes& codes : gases)
            volumes_m3_.push_back(gasZoneShape(mesh, codes).volume_m3);
        for (const FacetGroup& group : groups_)
            for (const Facet& facet : group.facets)
                ofGas_[group.gas].push_back(facet);
        std::erase_if(ofGas_, [](const std::vector<Facet>& facets) { return facets.empty(); });
    }

    GasLine make(std::size_t number) const {
        constexpr int tries = 8; // of a line that goes along an edge, or through no gas
        Chance chance(number + 1);
        for (int i = 0; i < tries && !ofGas_.empty(); ++i)
            if (std::optional<GasLine> line = make(chance))
                return std::move(*line);
        return {};
    }

  private:
    std::optional<GasLine> make(Chance& chance) const {
        const Vec3 from = placeOn(chance.of(ofGas_), chance),
                   to = placeOn(chance.of(ofGas_), chance);
        if (!(length(to - from) > 0.0))
            return std::nullopt;
        const Vec3 along = normalized(to - from);
        const std::vector<Crossing> walls = crossings(groups_, from, along);
        if (walls.size() < 2)
            return std::nullopt;
        constexpr double areBegunWithin = 0.15, areCutOff = 0.4;
        const auto between = [&](double first_m, double last_m) {
            return std::lerp(first_m, last_m, chance.upTo1());
        };
        double first_m = walls.front().distance_m, last_m = walls.back().distance_m;
        if (chance.upTo1() < areBegunWithin)
            first_m = between(first_m, last_m);
        if (chance.upTo1() < areCutOff)
            last_m = between(first_m, last_m);
        return along_(walls, first_m, last_m);
    }
    static Vec3 placeOn(const std::vector<Facet>& facets, Chance& chance) {
        const Facet& facet = chance.of(facets);
        double u = chance.upTo1(), v = chance.upTo1();
        if (u + v > 1.0) {
            u = 1.0 - u;
            v = 1.0 - v;
        }
        return facet[0] + (facet[1] - facet[0]) * u + (facet[2] - facet[0]) * v;
    }
    /// What a line meets between two distances; none where a wall was crossed once too few.
    std::optional<GasLine> along_(const std::vector<Crossing>& walls, double first_m,
                                  double last_m) const {
        GasLine line;
        std::vector<char> isIn(volumes_m3_.size(), 0);
        for (std::size_t i = 0; i < walls.size(); ++i) {
            isIn[walls[i].gas] ^= 1;
            const double begin_m = std::max(walls[i].distance_m, first_m);
            const double end_m =
                std::min(i + 1 < walls.size() ? walls[i + 1].distance_m : last_m, last_m);
            std::size_t innermost = isIn.size();
            for (std::size_t g = 0; g < isIn.size(); ++g)
                if (isIn[g] != 0 &&
                    (innermost == isIn.size() || volumes_m3_[g] < volumes_m3_[innermost]))
                    innermost = g;
            if (innermost == isIn.size() || !(end_m > begin_m))
                continue;
            if (!line.empty() && line.back().gas == innermost)
                line.back().length_m += end_m - begin_m;
            else
                line.push_back({innermost, end_m - begin_m});
        }
        if (line.empty() || std::ranges::find(isIn, 1) != isIn.end())
            return std::nullopt;
        return line;
    }

    std::vector<FacetGroup> groups_;
    std::vector<std::vector<Facet>> ofGas_;
    std::vector<double> volumes_m3_;
};

struct KnownLines {
    std::weak_ptr<const Mesh> mesh;
    std::vector<IrCodes> gases;
    std::shared_ptr<const std::vector<GasLine>> lines;
};

} // namespace

std::shared_ptr<const std::vector<GasLine>> gasLines(const std::shared_ptr<const Mesh>& mesh,
                                                     const std::vector<IrCodes>& gases) {
    static std::mutex mutex;
    static RecentlyUsed<KnownLines> known{16};
    const std::lock_guard lock(mutex);
    const auto isIt = [&](const KnownLines& one) {
        return one.gases == gases && one.mesh.lock() == mesh;
    };
    if (const KnownLines* found = known.find(isIt))
        return found->lines;
    const LineMaker maker(mesh, gases);
    std::vector<GasLine> lines(linesOfMesh);
    parallelFor(lines.size(), [&](std::size_t i) { lines[i] = maker.make(i); });
    std::erase_if(lines, [](const GasLine& line) { return line.empty(); });
    return known.add({mesh, gases, std::make_shared<const std::vector<GasLine>>(std::move(lines))})
        .lines;
}

} // namespace irsg
