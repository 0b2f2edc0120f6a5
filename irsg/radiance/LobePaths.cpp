#include "irsg/radiance/LobePaths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/RayVectors.h"

namespace irsg {

namespace {

/// A facet of a mirror, chosen by what it sends towards a viewer.
struct ChosenFacet {
    SurfaceDirection facet;
    /// By component: what stands for all facets, in parts of the albedo; 1 where all components
    /// send alike.
    SurfaceModel::Amounts weights{};
};

std::optional<ChosenFacet> chosenFacet(const SurfaceModel& model, const SurfaceDirection& to,
                                       double turn) {
    const std::size_t facets = model.facets().size();
    const auto partOf = [&](double step) {
        const double at = turn * step;
        return facets == 1 ? 0.5 : at - std::floor(at);
    };
    const double share = partOf(97.0), round = facets == 1 ? 0.0 : partOf(31.0);
    thread_local std::vector<std::pair<SurfaceDirection, SurfaceModel::Amounts>> all;
    all.clear();
    SurfaceModel::Amounts sums{};
    double whole = 0.0;
    for (std::size_t i = 0; i < facets; ++i) {
        const SurfaceDirection facet = model.facet(i, share, round);
        all.emplace_back(facet, model.facetWeights(to, facet));
        for (std::size_t k = 0; k < sums.size(); ++k) {
            sums[k] += all.back().second[k];
            whole += all.back().second[k];
        }
    }
    if (!(whole > 0.0))
        return std::nullopt;
    double left = turn * whole;
    for (const auto& [facet, sent] : all) {
        double own = 0.0;
        for (const double weight : sent)
            own += weight;
        left -= own;
        if (left >= 0.0 && &facet != &all.back().first)
            continue;
        if (!(own > 0.0))
            continue;
        ChosenFacet chosen{facet, {}};
        for (std::size_t k = 0; k < sums.size(); ++k)
            chosen.weights[k] = sums[k] > 0.0 ? sent[k] / sums[k] * (whole / own) : 0.0;
        return chosen;
    }
    return std::nullopt;
}

} // namespace

SurfaceAxes::SurfaceAxes(const Vec3& normal, const Vec3& view) : z(normal) {
    const Vec3 across = view - normal * product(normal, view);
    const double size = plainLength(across);
    if (size > 1e-9) {
        x = across * (1.0 / size);
    } else {
        const Vec3 other = std::abs(normal.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        x = normalized(cross(other, normal));
    }
    y = crossed(z, x);
}

SurfaceDirection SurfaceAxes::ofSeen(const Vec3& v) const {
    SurfaceDirection seen = of(v);
    seen.z = std::max(seen.z, 1e-4);
    return seen;
}

void LobePaths::Found::clear() {
    elsewhere = {};
    surfaces.clear();
    atmosphere.clear();
}

void LobePaths::Found::join() {
    LobePaths::join(surfaces);
    LobePaths::join(atmosphere);
}

void LobePaths::join(std::vector<Part>& parts) {
    std::ranges::sort(parts, {}, [](const Part& one) { return std::tie(one.set, one.number); });
    std::size_t last = 0;
    for (std::size_t i = 1; i < parts.size(); ++i) {
        Part &one = parts[i], &before = parts[last];
        if (one.number != before.number || one.set != before.set) {
            parts[++last] = one;
            continue;
        }
        for (std::size_t k = 0; k < SurfaceModel::mostComponents; ++k)
            before.weights[k] += one.weights[k];
    }
    parts.resize(std::min(parts.size(), last + 1));
}

void LobePaths::add(std::vector<Part>& to, int set, std::uint32_t number,
                    const SurfaceModel::Amounts& weights, double scale) {
    if (scale == 0.0)
        return;
    Part& part = to.emplace_back(Part{set, number, weights});
    for (double& weight : part.weights)
        weight *= scale;
}

bool LobePaths::goesOn(const Making& making, const Ray& ray, int row) {
    return !ray.panes.empty() ||
           (ray.met == SunShadows::Met::surface &&
            making.mirrors->isFollowed(making.mirrors->of(row), ray.end.row, 0));
}

void LobePaths::follow(const Making& making, Ray& ray, int row,
                       const SurfaceModel::Amounts& weights, double turn,
                       const PlacesAbout& placesAbout, Found& found) {
    const SurfaceModel& model = *(*making.models)[static_cast<std::size_t>(row)];
    Reach reach{making.mirrors->of(row), 0, {}};
    if (model.facets().size() == 1)
        reach.spread = SlopeSpread::of(model.roughness());
    if (go({making, placesAbout, found, turn}, ray, {{0, weights}}, reach))
        return;
    for (std::size_t k = 0; k < weights.size(); ++k)
        found.elsewhere[k] += weights[k];
}

bool LobePaths::go(const Way& way, Ray& ray, const std::vector<Carried>& carried,
                   const Reach& reach) {
    std::vector<Carried> passed = carried;
    for (SunShadows::Hit& pane : ray.panes) {
        meet(way, pane, ray.direction, passed, reach);
        for (Carried& one : passed)
            one.set = sets_.behind(one.set, way.making.rows->material(pane.row));
    }
    if (ray.met == SunShadows::Met::surface)
        meet(way, ray.end, ray.direction, passed, reach);
    if (ray.met == SunShadows::Met::nothing)
        way.placesAbout(ray.direction, [&](std::size_t place, double part) {
            for (const Carried& one : passed)
                add(way.found.atmosphere, one.set, static_cast<std::uint32_t>(place), one.weights,
                    part);
        });
    return ray.met != SunShadows::Met::other;
}

void LobePaths::meet(const Way& way, SunShadows::Hit& hit, const Vec3& direction,
                     const std::vector<Carried>& carried, const Reach& reach) {
    const Making& making = way.making;
    making.exchange->forEachReflected(
        hit.at.cell, hit.at.u, hit.at.v, [&](std::uint32_t number, float part) {
            for (const Carried& one : carried)
                add(way.found.surfaces, one.set, number, one.weights, static_cast<double>(part));
        });
    const SurfaceModel* const model = (*making.models)[static_cast<std::size_t>(hit.row)].get();
    if (model == nullptr || !making.mirrors->isFollowed(reach.most, hit.row, reach.mirrors))
        return;
    const SurfaceAxes axes(making.open->normalAt(hit), direction * -1.0);
    const SurfaceDirection to = axes.ofSeen(direction * -1.0);
    SurfaceModel::Amounts elsewhere;
    elsewhere.fill(1.0);
    const int lobe = making.rows->firstLobe(hit.row);
    const double turned = way.turn + 0.6180339887498949 * (reach.mirrors + 1);
    if (const auto chosen = chosenFacet(*model, to, turned - std::floor(turned))) {
        std::vector<Carried> next;
        std::array<bool, SurfaceModel::mostComponents> isFollowed{};
        for (std::size_t k = 0; k < model->components() && model->hasLobe(k); ++k) {
            const double scale = model->albedo(k, to.z) * chosen->weights[k];
            if (!making.mirrors->isComponentFollowed(hit.row, k) ||
                !MirrorReflectivity::matters(reach.most * scale *
                                             making.mirrors->amountOf(hit.row, k)))
                continue;
            elsewhere[k] -= chosen->weights[k];
            isFollowed[k] = true;
            for (const Carried& one : carried) {
                Carried& more = next.emplace_back(one);
                more.set = sets_.behind(one.set, {making.rows->keyOf(hit.row).first,
                                                  mirrorMaterial(lobe + static_cast<int>(k))});
                for (double& weight : more.weights)
                    weight *= scale;
            }
        }
        Reach onwards{reach.most * making.mirrors->of(hit.row), reach.mirrors + 1, {}};
        if (model->facets().size() == 1) {
            onwards.spread = SlopeSpread::of(model->roughness());
            onwards.spread.xx += reach.spread.xx;
            onwards.spread.yy += reach.spread.yy;
        }
        Ray ray{axes.to(mirrored(to, chosen->facet)), {}, {}, {}};
        if (!next.empty()) {
            making.open->goOnFrom(hit);
            ray.met = making.open->met(hit.place, ray.direction, ray.end, ray.panes);
            if (!go(way, ray, next, onwards))
                for (std::size_t k = 0; k < elsewhere.size(); ++k)
                    elsewhere[k] += isFollowed[k] ? chosen->weights[k] : 0.0;
        }
    }
    addMirror(way, hit, axes, to, carried, elsewhere, reach);
}

void LobePaths::addMirror(const Way& way, const SunShadows::Hit& hit, const SurfaceAxes& axes,
                          const SurfaceDirection& to, const std::vector<Carried>& carried,
                          const SurfaceModel::Amounts& elsewhere, const Reach& reach) {
    const Making& making = way.making;
    const SurfaceModel& model = *(*making.models)[static_cast<std::size_t>(hit.row)];
    const int lobe = making.rows->firstLobe(hit.row);
    const auto firstComponent =
        static_cast<std::size_t>(making.exchange->firstComponentOf(hit.row)) +
        making.exchange->firstComponents();
    const SurfaceDirection sun = axes.of(making.sun);
    SlopeSpread spread = SlopeSpread::of(model.roughness());
    spread.xx += sunDiscSpread + reach.spread.xx;
    spread.yy += sunDiscSpread + reach.spread.yy;
    for (std::size_t k = 0; k < model.components(); ++k) {
        const double albedo = model.albedo(k, to.z), mean = model.meanAlbedo(k);
        const double glint = !making.isSunSmart ? albedo
                             : sun.z > 0.0      ? pi * model.brdf_per_sr(k, to, sun, spread)
                                                : 0.0;
        // Of a component that is not followed, on the whole what it shows is its mean.
        const double change = std::max(std::abs(albedo - mean), std::abs(glint - mean));
        if (!making.mirrors->isComponentFollowed(hit.row, k))
            continue;
        if (elsewhere[k] == 1.0 && !MirrorReflectivity::matters(
                                       reach.most * making.mirrors->amountOf(hit.row, k) * change))
            continue;
        for (const Carried& one : carried) {
            const int set = sets_.behind(one.set, {making.rows->keyOf(hit.row).first,
                                                   mirrorMaterial(lobe + static_cast<int>(k))});
            add(way.found.surfaces, one.set, static_cast<std::uint32_t>(firstComponent + k),
                one.weights, albedo - mean);
            making.exchange->forEachReceived(
                hit.at.cell, hit.at.u, hit.at.v, [&](std::uint32_t number, float part) {
                    add(way.found.surfaces, set, number, one.weights,
                        static_cast<double>(part) * (elsewhere[k] * albedo - mean));
                });
            // Lobes see no gas by direction: what it changes counts on the whole.
            making.exchange->forEachGasChange(
                hit.at.cell, hit.at.u, hit.at.v, [&](std::uint32_t number, float part) {
                    add(way.found.surfaces, set, number, one.weights,
                        static_cast<double>(part) * (1.0 - elsewhere[k]) * albedo);
                });
            making.exchange->forEachSun(hit.at.cell, hit.at.u, hit.at.v,
                                        [&](std::uint32_t number, float factor) {
                                            add(way.found.surfaces, set, number, one.weights,
                                                static_cast<double>(factor) * (glint - mean));
                                        });
        }
    }
}

} // namespace irsg
