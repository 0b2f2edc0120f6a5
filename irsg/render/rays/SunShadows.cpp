#include "irsg/render/rays/SunShadows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/LightDirections.h"
#include "irsg/render/rays/TileSamples.h"

namespace irsg {

namespace {

constexpr std::size_t raysOfDisc = 64;

using MaterialSet = std::vector<std::pair<int, int>>;

/// Places on the unit disc, evenly spread (Vogel's spiral) and turned by part of a circle that
/// differs from sample to sample.
std::array<double, 2> onDisc(std::size_t i, std::size_t turn) {
    const double golden = pi * (3.0 - std::sqrt(5.0));
    const double turned = static_cast<double>(turn % 4096) * 0.6180339887498949;
    const double angle = golden * static_cast<double>(i) + 2.0 * pi * (turned - std::floor(turned));
    const double radius = std::sqrt((static_cast<double>(i) + 0.5) / raysOfDisc);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Where light from the sun passes, in the order of some rows.
struct Passages {
    std::vector<GeometrySamples::Through> through;
    std::vector<MaterialSet> sets;
    std::map<MaterialSet, std::uint32_t> numbers;

    std::uint32_t numberOf(const MaterialSet& set) {
        const auto [place, isNew] =
            numbers.try_emplace(set, static_cast<std::uint32_t>(sets.size()));
        if (isNew)
            sets.push_back(set);
        return place->second;
    }
};

/// The factors of a layer where they lie.
float* factorOf(GeometrySamples& samples, std::size_t sample, std::optional<std::size_t> fragment,
                std::size_t f) {
    if (fragment)
        return &samples.words[*fragment * samples.wordsPerFragment + 4 + f];
    return &samples.opaqueFactor(sample, f);
}

} // namespace

/// Who looks, and at what.
struct SunShadows::Source {
    const SurfaceScene* scene = nullptr;
    const SampleTile* tile = nullptr;
    Viewpoint eye;
    EyeDirections directions;
    double sampleWidth = 0.0;
    std::vector<std::size_t> casters;  ///< by row of the drawing
    std::vector<Vec3> towards;         ///< world, by factor
    std::vector<const Sunlit*> sunlit; ///< by factor, null where nothing is known
    std::vector<std::size_t> shadowed; ///< factors

    Vec3 worldOf(const Vec3& eyeDirection) const {
        return eye.right * eyeDirection.x + eye.up * eyeDirection.y + eye.backward * eyeDirection.z;
    }
};

struct SunShadows::Shaded {
    double free = 0.0; ///< part of the light that nothing weakens
    std::map<MaterialSet, double> through;

    void add(const Shaded& other, double weight) {
        free += weight * other.free;
        for (const auto& [set, part] : other.through)
            through[set] += weight * part;
    }
    double visible() const {
        double sum = free;
        for (const auto& [set, part] : through)
            sum += part;
        return sum;
    }
};

SunShadows::SunShadows(std::vector<Caster> casters, std::vector<bool> reflects, bool isDisc)
    : casters_(std::move(casters)), reflects_(std::move(reflects)), isDisc_(isDisc) {
    for (const Caster& caster : casters_) {
        toWorld_.push_back(caster.pose.attitude.rotation());
        toMesh_.push_back(toWorld_.back().transposed());
        if (caster.entity >= 0)
            caster.mesh->findCloseSheets();
    }
}

SunShadows::Source SunShadows::sourceOf(const SurfaceScene& scene, const SampleTile& tile) const {
    Source source;
    source.scene = &scene;
    source.tile = &tile;
    source.eye = scene.camera->viewpoint();
    source.directions = {scene.camera->sensor(), tile};
    source.sampleWidth = sampleWidthOf(scene.camera->sensor(), tile);
    source.casters.resize(scene.rows.size());
    for (std::size_t c = 0; c < casters_.size(); ++c)
        for (const int row : casters_[c].rows)
            source.casters[static_cast<std::size_t>(row)] = c;
    for (std::size_t f = 0; f < scene.factors.shadowedFrom.size(); ++f) {
        const int from = scene.factors.shadowedFrom[f];
        source.towards.push_back(
            from < 0 ? Vec3{}
                     : source.worldOf(
                           scene.factors.directionsEye[static_cast<std::size_t>(from)].second));
        if (from >= 0)
            source.shadowed.push_back(f);
        constexpr double rounding = 1e-12; // into eye space and back
        const auto known = std::ranges::find_if(sunlit_, [&](const Sunlit& one) {
            return length(one.towards - source.towards.back()) <= rounding;
        });
        source.sunlit.push_back(known != sunlit_.end() ? &*known : nullptr);
    }
    return source;
}

SunShadows::OpenPaths SunShadows::openPaths(const SurfaceScene& scene,
                                            const SampleTile& tile) const {
    OpenPaths paths;
    paths.shadows_ = this;
    paths.source_ = std::make_shared<const Source>(sourceOf(scene, tile));
    return paths;
}

SunShadows::Place SunShadows::OpenPaths::placeOf(const Vec3& eyeDirection, int row,
                                                 double distance_m, int column,
                                                 Neighbours& neighbours) const {
    Place place = shadows_->placeOf(*source_, eyeDirection, row, distance_m, column, neighbours);
    place.start_m = shadows_->startOf_m(place);
    return place;
}

bool SunShadows::OpenPaths::isOpen(const Place& from, const Vec3& towardsEye) const {
    thread_local std::vector<std::pair<int, int>> through;
    through.clear();
    return shadows_->reaches(from, from.start_m, source_->worldOf(towardsEye), false, through);
}

SunShadows::Met SunShadows::OpenPaths::met(const Place& from, const Vec3& towardsEye, Hit& end,
                                           std::vector<Hit>& panes) const {
    return shadows_->met(from, source_->worldOf(towardsEye), end, panes);
}

void SunShadows::OpenPaths::goOnFrom(Hit& hit) const {
    hit.place.start_m = shadows_->startOf_m(hit.place);
}

Vec3 SunShadows::OpenPaths::inEye(const Vec3& direction) const {
    const Viewpoint& eye = source_->eye;
    return {dot(direction, eye.right), dot(direction, eye.up), dot(direction, eye.backward)};
}

Vec3 SunShadows::OpenPaths::normalAt(const Hit& hit) const {
    const Caster& caster = shadows_->casters_[hit.place.caster];
    return inEye(turned(shadows_->toWorld_[hit.place.caster],
                        caster.mesh->normal(hit.place.hit) * (hit.place.hit.isFront ? 1.0 : -1.0)));
}

bool SunShadows::name(std::size_t caster, Hit& hit) const {
    if (caster >= places_.meshes.size())
        return false;
    const ExchangeMesh::Place on = places_.meshes[caster]->placeOf(hit.place.hit);
    if (on.cell == ExchangeMesh::none)
        return false;
    hit.place.caster = caster;
    hit.place.distance_m = hit.place.hit.distance_m;
    hit.place.isFound = true;
    hit.row = casters_[caster].rows[static_cast<std::size_t>(hit.place.hit.piece)];
    hit.at = {places_.firstCell[caster] + on.cell, on.u, on.v};
    return true;
}

SunShadows::Met SunShadows::met(const Place& from, const Vec3& towards, Hit& end,
                                std::vector<Hit>& panes) const {
    thread_local std::vector<RayHit> through;
    panes.clear();
    std::size_t nearest = casters_.size();
    RayHit hit;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < casters_.size(); ++c) {
        const Caster& caster = casters_[c];
        Ray ray{turned(toMesh_[c], from.start_m - caster.pose.position_m),
                turned(toMesh_[c], towards), 0.0, nearest_m};
        bool isMet = caster.mesh->meet(ray, caster.uses, 0.0, hit, through);
        // The smooth surface that it is on is not in its way: a facet and those that touch it.
        const auto isOfOwn = [&](const RayHit& one) {
            return from.isFound && c == from.caster && caster.mesh->touch(one, from.hit);
        };
        constexpr int mostTouching = 8;
        for (int i = 0; i < mostTouching && isMet && isOfOwn(hit); ++i) {
            ray.from_m = hit.distance_m + caster.mesh->rounding_m();
            isMet = caster.mesh->meet(ray, caster.uses, 0.0, hit, through);
        }
        for (const RayHit& one : through) {
            Hit pane{{c, ray, 0.0, one, false, {}}, 0, {}};
            if (caster.uses[static_cast<std::size_t>(one.piece)].pane > 0 && !isOfOwn(one) &&
                name(c, pane))
                panes.push_back(pane);
        }
        if (!isMet)
            continue;
        nearest = c;
        nearest_m = hit.distance_m;
        end.place.ray = ray;
        end.place.hit = hit;
    }
    if (!panes.empty()) {
        std::erase_if(panes, [&](const Hit& pane) { return pane.place.distance_m >= nearest_m; });
        std::ranges::stable_sort(panes, {}, [](const Hit& pane) { return pane.place.distance_m; });
    }
    if (nearest == casters_.size())
        return Met::nothing;
    return name(nearest, end) ? Met::surface : Met::other;
}

SunShadows::Place SunShadows::placeOf(const Source& source, const Vec3& eyeDirection, int row,
                                      double distance_m, int column, Neighbours& neighbours) const {
    const std::size_t number = source.casters[static_cast<std::size_t>(row)];
    const Caster& caster = casters_[number];
    const Rotation& toMesh = toMesh_[number];
    Place place;
    place.caster = number;
    place.distance_m = distance_m;
    place.ray.origin_m = turned(toMesh, source.eye.position_m - caster.pose.position_m);
    place.ray.direction = turned(toMesh, source.worldOf(eyeDirection));
    // Distances come in float, and OpenGL snaps corners to a part of a sample.
    constexpr double snap = 1.0 / 64.0;
    const double off_m = distance_m * (4e-6 + 2.0 * source.sampleWidth);
    const double near_m = distance_m * (4e-7 + snap * source.sampleWidth);
    const auto again = [&](const Neighbours::Known& nearby) {
        if (nearby.row != row ||
            !caster.mesh->standsAlone(nearby.piece, nearby.facet, 2.0 * near_m))
            return false;
        const PieceUse& use = caster.uses[static_cast<std::size_t>(nearby.piece)];
        place.isFound = caster.mesh->again(place.ray, nearby.piece, nearby.facet, use, distance_m,
                                           near_m, place.hit);
        return place.isFound;
    };
    if (neighbours.last_.empty()) {
        neighbours.last_.resize(source.casters.size());
        neighbours.above_.resize(static_cast<std::size_t>(source.tile->width()));
    }
    Neighbours::Known& last = neighbours.last_[static_cast<std::size_t>(row)];
    Neighbours::Known& above = neighbours.above_[static_cast<std::size_t>(column)];
    if (!again(last) && !again(above)) {
        const auto isOfRow = [&](int piece) {
            return caster.rows[static_cast<std::size_t>(piece)] == row;
        };
        if (const auto hit =
                caster.mesh->seenAt(place.ray, {distance_m, near_m, off_m}, caster.uses, isOfRow)) {
            place.hit = *hit;
            place.isFound = true;
        }
    }
    if (place.isFound)
        last = above = {row, place.hit.piece, place.hit.facet};
    return place;
}

bool SunShadows::isAllLit(const Place& place, const Sunlit* known) const {
    if (known == nullptr || !place.isFound)
        return false;
    const SunlitFacets* const facets = known->facets[place.caster].get();
    return facets != nullptr && facets->isLit(place.hit);
}

Vec3 SunShadows::startOf_m(const Place& place) const {
    const Caster& caster = casters_[place.caster];
    const Vec3 start = place.isFound ? caster.mesh->lifted(place.hit, place.ray)
                                     : place.ray.origin_m + place.ray.direction * place.distance_m;
    return caster.pose.position_m + turned(toWorld_[place.caster], start);
}

bool SunShadows::reaches(const Place& place, const Vec3& start_m, const Vec3& towards, bool isLit,
                         std::vector<std::pair<int, int>>& through) const {
    thread_local std::vector<int> pieces;
    for (std::size_t c = 0; c < casters_.size(); ++c) {
        const bool isOwn = place.isFound && c == place.caster;
        if (isOwn && isLit)
            continue;
        const Caster& caster = casters_[c];
        const Rotation& toMesh = toMesh_[c];
        const Ray ray{turned(toMesh, start_m - caster.pose.position_m), turned(toMesh, towards)};
        pieces.clear();
        if (!caster.mesh->letsPass(ray, caster.uses, isOwn ? &place.hit : nullptr, pieces))
            return false;
        for (const int piece : pieces)
            through.emplace_back(caster.entity, caster.materials[static_cast<std::size_t>(piece)]);
    }
    std::ranges::sort(through);
    return true;
}

SunShadows::Shaded SunShadows::lightAt(const Place& place, const Vec3& towardsSun, bool isLit,
                                       std::size_t turn) const {
    Shaded light;
    const std::size_t rays = isDisc_ ? raysOfDisc : 1;
    const double part = 1.0 / static_cast<double>(rays);
    Vec3 right, up;
    double radius = 0.0;
    if (isDisc_) {
        std::tie(right, up) = acrossTo(towardsSun);
        radius = std::tan(discRadius_rad);
    }
    const Vec3 start_m = startOf_m(place);
    MaterialSet through;
    for (std::size_t i = 0; i < rays; ++i) {
        Vec3 towards = towardsSun;
        if (isDisc_) {
            const auto [x, y] = onDisc(i, turn);
            towards = normalized(towardsSun + right * (x * radius) + up * (y * radius));
        }
        through.clear();
        if (!reaches(place, start_m, towards, isLit, through))
            continue;
        if (through.empty())
            light.free += part;
        else
            light.through[through] += part;
    }
    return light;
}

void SunShadows::apply(const SheetScene& sheet, bool withVisibility,
                       GeometrySamples& samples) const {
    samples.through.clear();
    samples.throughSets.clear();
    samples.sunVisibility.assign(withVisibility ? samples.size() : 0, 0.0f);
    const bool withPlaces = !places_.matters.empty();
    samples.skyVisibility.assign(withVisibility && withPlaces ? samples.size() : 0, 0.0f);
    samples.opaquePlaces.assign(withPlaces ? samples.size() : 0, {});
    samples.fragmentPlaces.assign(withPlaces ? samples.words.size() / samples.wordsPerFragment : 0,
                                  {});
    std::vector<Source> sources;
    for (std::size_t w = 0; w < sheet.scenes.size(); ++w)
        sources.push_back(sourceOf(sheet.scenes[w], sheet.sheet.tiles[w]));

    const auto lightOf = [&](const Source& source, const Place& place, std::size_t f,
                             std::size_t sample) {
        const bool isLit = isAllLit(place, source.sunlit[f]);
        return isLit && casters_.size() == 1 ? Shaded{1.0, {}}
                                             : lightAt(place, source.towards[f], isLit, sample);
    };
    // Each member has a shadow of its own, and its own part of the mean of their factors.
    const auto lightOfGroup = [&](const Source& source, const Place& place, std::size_t f,
                                  std::size_t sample, Neighbours& neighbours, int row, int column) {
        constexpr std::size_t members = GeometrySamples::samplesOfGroup;
        const auto group = samples.groupOf(sample, source.tile->stride());
        const auto stands = static_cast<std::size_t>(samples.groups[sample]) - 1;
        const auto mean = static_cast<double>(samples.opaqueFactor(sample, f));
        std::array<double, members> factors{};
        double others = 0.0;
        for (std::size_t i = 0; i < members; ++i)
            if (i != stands)
                others += factors[i] = static_cast<double>(samples.opaqueFactor(group[i], f));
        factors[stands] = std::max(static_cast<double>(members) * mean - others, 0.0);
        Shaded all;
        for (std::size_t i = 0; i < members; ++i) {
            const double part = factors[i] / (static_cast<double>(members) * mean);
            if (!(part > 0.0))
                continue;
            if (i == stands) {
                all.add(lightOf(source, place, f, sample), part);
                continue;
            }
            const int x = column + static_cast<int>(i % 2) - static_cast<int>(stands % 2);
            const int y = row + static_cast<int>(i / 2) - static_cast<int>(stands / 2);
            const Place own =
                placeOf(source, source.directions.at(x, y),
                        static_cast<int>(samples.opaque[4 * group[i]]) - 1,
                        static_cast<double>(samples.distances_m[group[i]]), x, neighbours);
            all.add(lightOf(source, own, f, group[i]), part);
        }
        constexpr double rounding = 1e-5;
        if (all.free > 1.0 - rounding)
            all.free = 1.0;
        return all;
    };
    const auto shade = [&](const Source& source, Passages& passages, Neighbours& neighbours,
                           int row, int column) {
        const std::size_t sample = indexOf(*source.tile, column, row);
        if (samples.isEmpty(sample))
            return;
        const Vec3 eyeDirection = source.directions.at(column, row);
        std::uint32_t number = 0;
        const auto [firstFragment, endOfFragments] = samples.fragmentsOf(sample);
        samples.forEachLayer(sample, [&](const GeometrySamples::Layer& layer) {
            const std::uint32_t own = number++;
            const auto drawnRow = static_cast<std::size_t>(layer.row);
            const bool isOfMatter = withVisibility || reflects_.empty() || reflects_[drawnRow];
            if (!isOfMatter)
                return;
            std::optional<std::size_t> fragment;
            if (firstFragment + own < endOfFragments)
                fragment = firstFragment + own;
            std::optional<Place> place;
            if (withVisibility && withPlaces && own == 0)
                samples.skyVisibility[sample] = 1.0f;
            if (withPlaces && places_.matters[drawnRow]) {
                place = placeOf(source, eyeDirection, layer.row,
                                static_cast<double>(layer.distance_m), column, neighbours);
                if (place->isFound) {
                    GeometrySamples::Place& told =
                        fragment ? samples.fragmentPlaces[*fragment] : samples.opaquePlaces[sample];
                    const ExchangeMesh::Place on =
                        places_.meshes[place->caster]->placeOf(place->hit);
                    told = on.cell == ExchangeMesh::none
                               ? GeometrySamples::Place{}
                               : GeometrySamples::Place{places_.firstCell[place->caster] + on.cell,
                                                        on.u, on.v};
                    if (withVisibility && own == 0 && on.cell != ExchangeMesh::none) {
                        const std::array<float, 3> open = places_.openAt(told.cell);
                        samples.skyVisibility[sample] =
                            (1.0f - on.u - on.v) * open[0] + on.u * open[1] + on.v * open[2];
                    }
                }
            }
            for (const std::size_t f : source.shadowed) {
                float* factor = factorOf(samples, sample, fragment, f);
                if (!(*factor > 0.0f))
                    continue;
                if (!place)
                    place = placeOf(source, eyeDirection, layer.row,
                                    static_cast<double>(layer.distance_m), column, neighbours);
                const Shaded light =
                    samples.standsForGroup(sample)
                        ? lightOfGroup(source, *place, f, sample, neighbours, row, column)
                        : lightOf(source, *place, f, sample);
                if (light.free == 1.0) {
                    if (withVisibility && own == 0)
                        samples.sunVisibility[sample] = 1.0f;
                    continue;
                }
                const auto whole = static_cast<double>(*factor);
                *factor = static_cast<float>(whole * light.free);
                for (const auto& [set, part] : light.through)
                    passages.through.push_back(
                        {static_cast<std::uint32_t>(sample), own, passages.numberOf(set),
                         static_cast<std::uint32_t>(f), static_cast<float>(whole * part)});
                if (withVisibility && own == 0)
                    samples.sunVisibility[sample] = static_cast<float>(light.visible());
            }
        });
    };
    const std::vector<TileRows> pieces = rowsOf(sheet.sheet);
    std::vector<Passages> found(pieces.size());
    parallelFor(pieces.size(), [&](std::size_t i) {
        const Source& source = sources[pieces[i].tile];
        Neighbours neighbours;
        for (int row = pieces[i].first; row < pieces[i].last; ++row)
            for (int column = 0; column < source.tile->width(); ++column)
                shade(source, found[i], neighbours, row, column);
    });

    std::map<MaterialSet, std::uint32_t> numbers;
    for (Passages& passages : found)
        for (GeometrySamples::Through& one : passages.through) {
            const MaterialSet& set = passages.sets[one.set];
            const auto [known, isNew] =
                numbers.try_emplace(set, static_cast<std::uint32_t>(samples.throughSets.size()));
            if (isNew)
                samples.throughSets.push_back(set);
            one.set = known->second;
            samples.through.push_back(one);
        }
    std::ranges::sort(samples.through, [](const auto& a, const auto& b) {
        return std::tie(a.sample, a.layer, a.factor, a.set) <
               std::tie(b.sample, b.layer, b.factor, b.set);
    });
}

} // namespace irsg
