#include "irsg/scene/PreparedEntities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <string>

#include "irsg/core/BuildId.h"
#include "irsg/core/CacheStore.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FreedMemory.h"
#include "irsg/radiance/PointSources.h"
#include "irsg/radiance/RangeGeometry.h"

namespace irsg {

namespace {

/// Of a model whose making of light leaves memory behind that others may want.
constexpr std::size_t manyFacets = 200'000;

bool haveEqualFacets(const RayMesh& one, const RayMesh& other) {
    if (one.pieces() != other.pieces() || one.facets() != other.facets())
        return false;
    for (std::size_t piece = 0; piece < one.pieces(); ++piece) {
        if (one.facetsOf(piece) != other.facetsOf(piece))
            return false;
        for (unsigned f = 0; f < one.facetsOf(piece); ++f) {
            const auto a = one.facet(piece, f).corners_m, b = other.facet(piece, f).corners_m;
            for (std::size_t corner = 0; corner < a.size(); ++corner)
                if (a[corner].x != b[corner].x || a[corner].y != b[corner].y ||
                    a[corner].z != b[corner].z)
                    return false;
        }
    }
    return true;
}

/// What bodies see of themselves as far as any renderer of the process holds it: a picture and an
/// analysis of one model find it once.
class KnownBodyLight {
  public:
    std::shared_ptr<const BodyLight> find(const RayMesh& mesh, const PieceUses& uses, double error,
                                          BodyPlace place) {
        const std::scoped_lock lock(mutex_);
        std::erase_if(known_, [](const Entry& one) { return one.light.expired(); });
        for (const Entry& one : known_) {
            if (one.error != error || one.place != place || one.uses != uses)
                continue;
            if (auto light = one.light.lock(); light && haveEqualFacets(light->mesh().rays(), mesh))
                return light;
        }
        return nullptr;
    }
    void add(const PreparedModel::KnownLight& known) {
        const std::scoped_lock lock(mutex_);
        known_.push_back({known.uses, known.error, known.place, known.light});
    }

  private:
    struct Entry {
        PieceUses uses;
        double error;
        BodyPlace place;
        std::weak_ptr<const BodyLight> light;
    };
    std::mutex mutex_;
    std::vector<Entry> known_;
};

KnownBodyLight& knownBodyLight() {
    static KnownBodyLight known;
    return known;
}

ExchangeResolution resolutionFor(double error, BodyPlace place, double radius_m) {
    ExchangeResolution resolution;
    resolution.edgePerDistance *= ExchangeResolution::spacingFor(error);
    resolution.isAlone = place == BodyPlace::alone;
    resolution.hasInsides = resolution.isAlone || place == BodyPlace::overTerrain;
    if (place == BodyPlace::amongOthers)
        resolution.longestEdge_m = 2.0 * radius_m / 16.0;
    return resolution;
}

std::shared_ptr<const BodyLight> madeLight(const std::shared_ptr<const RayMesh>& facets,
                                           const PieceUses& uses, double error,
                                           const ExchangeResolution& resolution) {
    auto mesh = std::make_shared<ExchangeMesh>(facets, uses, resolution);
    auto nodes = std::make_shared<const ExchangeNodes>(mesh, resolution);
    mesh->forgetWays();
    auto made = std::make_shared<const BodyLight>(std::move(nodes), uses, error);
    if (facets->facets() > manyFacets)
        giveBackFreedMemory();
    return made;
}

/// What bodies see of themselves, on disk. Large models take as long to read as to compute what
/// few rays find out.
std::optional<CacheStore> storeFor(const RayMesh& facets) {
    return facets.facets() > manyFacets ? std::nullopt
                                        : CacheStore::ofUser({"exchange", std::uintmax_t{1} << 30});
}

/// All that it depends on, and by which code it is made. Empty where nobody knows that.
std::string keyOf(const RayMesh& facets, const PieceUses& uses, double error, BodyPlace place,
                  const ExchangeResolution& resolution) {
    if (buildId().empty())
        return {};
    CacheKey key;
    key.add(buildId()).add(error).add(static_cast<double>(place)).add(resolution.longestEdge_m);
    std::vector<double> corners_m;
    for (std::size_t piece = 0; piece < facets.pieces(); ++piece) {
        const PieceUse& use = uses[piece];
        key.add(static_cast<double>(facets.facetsOf(piece)));
        key.add(std::array{use.isThere ? 1.0 : 0.0, use.transparent ? 1.0 : 0.0,
                           use.cullsBackFaces ? 1.0 : 0.0, static_cast<double>(use.layer),
                           static_cast<double>(use.pane)});
        for (unsigned f = 0; f < facets.facetsOf(piece); ++f)
            for (const Vec3& corner_m : facets.facet(piece, f).corners_m)
                corners_m.insert(corners_m.end(), {corner_m.x, corner_m.y, corner_m.z});
    }
    return key.addDigest(corners_m).text();
}

std::shared_ptr<const BodyLight> keptOrMade(const std::shared_ptr<const RayMesh>& facets,
                                            const PieceUses& uses, double error, BodyPlace place,
                                            double radius_m) {
    const ExchangeResolution resolution = resolutionFor(error, place, radius_m);
    const std::optional<CacheStore> store = storeFor(*facets);
    const std::string key = store ? keyOf(*facets, uses, error, place, resolution) : std::string();
    if (key.empty())
        return madeLight(facets, uses, error, resolution);
    if (const auto bytes = store->find(key))
        if (auto kept = BodyLight::read(facets, *bytes))
            return kept;
    auto made = madeLight(facets, uses, error, resolution);
    store->keep(key, made->written());
    return made;
}

} // namespace

const std::shared_ptr<const RayMesh>& PreparedModel::forRays() {
    if (!rayMesh)
        rayMesh = RayMesh::of(model->mesh());
    return rayMesh;
}

const std::vector<double>& PreparedModel::areasOfPieces_m2() {
    if (!areas_m2.empty())
        return areas_m2;
    const RayMesh& rays = *forRays();
    for (std::size_t piece = 0; piece < rays.pieces(); ++piece) {
        double& sum = areas_m2.emplace_back();
        for (unsigned f = 0; f < rays.facetsOf(piece); ++f) {
            const std::array<Vec3, 3> c = rays.facet(piece, f).corners_m;
            sum += 0.5 * length(cross(c[1] - c[0], c[2] - c[0]));
        }
    }
    return areas_m2;
}

std::shared_ptr<const BodyLight> PreparedModel::lightBetween(const PieceUses& uses, double error,
                                                             BodyPlace place) {
    const KnownLight* const known = light.find([&](const KnownLight& one) {
        return one.error == error && one.place == place && one.uses == uses;
    });
    if (known != nullptr)
        return known->light;
    if (auto held = knownBodyLight().find(*forRays(), uses, error, place))
        return light.add({uses, error, place, std::move(held)}).light;
    auto made = keptOrMade(forRays(), uses, error, place, mesh().sphere.radius_m);
    const KnownLight& added = light.add({uses, error, place, std::move(made)});
    knownBodyLight().add(added);
    return added.light;
}

void PreparedEntities::keep(const std::vector<Entity>& entities) {
    std::erase_if(models_, [&](const PreparedModel& known) {
        return std::ranges::find(entities, known.model, &Entity::model) == entities.end();
    });
    for (const Entity& entity : entities) {
        if (!entity.model || !entity.database)
            throw LogicError("an entity needs a model and a database");
        if (std::ranges::find(models_, entity.model, &PreparedModel::model) != models_.end())
            continue;
        models_.push_back({.model = entity.model});
    }
}

PreparedModel& PreparedEntities::of(const Entity& entity) {
    const auto found = std::ranges::find(models_, entity.model, &PreparedModel::model);
    if (found == models_.end())
        throw LogicError("an entity was drawn that was not prepared");
    return *found;
}

Vec3 PreparedEntities::referencePoint(const Entity& entity) {
    if (entity.referencePoint_m)
        return *entity.referencePoint_m;
    const Reference* const found = references_.find([&](const Reference& known) {
        return known.model == entity.model && known.database == entity.database &&
               known.fallbackMaterial == entity.fallbackMaterial;
    });
    if (found != nullptr)
        return found->point_m;
    const BoundingBox opaque = entity.model->boundsOf([&](const IrCodes& codes) {
        const Material* material = materialEntry(entity, codes.material);
        return !material || material->isOpaque();
    });
    const BoundingBox& box = opaque.valid() ? opaque : entity.model->bounds();
    return references_.add({entity.model, entity.database, entity.fallbackMaterial, box.centre()})
        .point_m;
}

double PreparedEntities::reach_m(const Entity& entity) {
    const BoundingSphere& sphere = entity.model->mesh()->sphere;
    return sphere.radius_m + length(sphere.centre_m - referencePoint(entity));
}

Vec3 PreparedEntities::towards(const Entity& entity, const Vec3& place_m) {
    return normalized(place_m - entity.pose.toWorld(referencePoint(entity)));
}

Vec3 PreparedEntities::lineOfSight(const Entity& entity, const Vec3& place_m) {
    return PointSources::onGrid(entity.pose.attitude.rotation().transposed() *
                                    towards(entity, place_m),
                                RangeGeometry::directionStep);
}

CameraFrame PreparedEntities::cameraAlong(const Entity& entity, const Vec3& lineOfSight,
                                          double distance_m, Sensor like) {
    // Pixels that are small in terms of the entity, as each has the solid angle of its middle.
    constexpr int pixels = 32;
    const Rotation toWorld = entity.pose.attitude.rotation();
    const Vec3 at_m = entity.pose.toWorld(referencePoint(entity));
    like.width_px = like.height_px = pixels;
    like.horizontalFieldOfView_rad = 2.0 * std::asin(reach_m(entity) / distance_m);
    return {like, Viewpoint::lookAt(at_m + toWorld * lineOfSight * distance_m, at_m,
                                    toWorld * Vec3{0, 0, 1}, toWorld * Vec3{0, 1, 0})};
}

} // namespace irsg
