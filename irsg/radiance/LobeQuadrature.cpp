#include "irsg/radiance/LobeQuadrature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiance/LobeQuadratureLayers.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Of so many samples each follows all of its facets to what they reflect; of more, one in a few,
/// in turn.
constexpr std::size_t samplesOfAllFacets = 20'000, mostStep = 6;

/// The level part of a direction as a unit vector; of a vertical one any level one.
Vec3 levelOf(const Vec3& direction, const Vec3& zenith) {
    const Vec3 level = direction - zenith * product(direction, zenith);
    const double size = plainLength(level);
    if (size > 1e-9)
        return level * (1.0 / size);
    return normalized(cross(std::abs(zenith.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, zenith));
}

/// A spread that is at least `all` in every direction: what is wider than samples lie apart falls
/// between none, and widening it would move the sun's glint.
SlopeSpread atLeast(const SlopeSpread& spread, double all) {
    const double mean = 0.5 * (spread.xx + spread.yy), half = 0.5 * (spread.xx - spread.yy);
    const double apart = std::hypot(half, spread.xy);
    const double most = std::max(mean + apart, all), least = std::max(mean - apart, all);
    // Along the axes of the spread.
    const double level = 0.5 * (most + least),
                 tilt = apart > 0.0 ? 0.5 * (most - least) / apart : 0.0;
    return {level + tilt * half, tilt * spread.xy, level - tilt * half};
}

} // namespace

/// Of a piece of the samples.
struct LobeQuadrature::Found {
    std::vector<GeometrySamples::Lobe> lobes;
    std::vector<GeometrySamples::Reflected> reflected;
    std::vector<GeometrySamples::Specular> speculars; // nodes as keys, `table` as drawn row
    std::vector<LobeQuadratureTable::ViewCell> cells; // of each of those
    std::vector<float> scales;
    OccluderStacks sets; // of what is reflected
};

LobeQuadrature::LobeQuadrature(const SurfaceRows& rows, Making making)
    : rows_(rows), making_(std::move(making)) {
    for (const auto& model : making_.models)
        divisions_.push_back(model && LobeQuadratureTable::serves(*model)
                                 ? LobeQuadratureTable::divisionsOf(*model)
                                 : 0);
}

SlopeSpread LobeQuadrature::spreadOf(const Tile& own, int row, int column,
                                     const GeometrySamples& samples,
                                     const DirectionalLayer& layer) const {
    SlopeSpread spread = SlopeSpread::of(layer.model.roughness());
    spread.xx += sunDiscSpread;
    spread.yy += sunDiscSpread;
    if (!samples.isOpaque(layer.sample) ||
        static_cast<int>(samples.opaque[4 * std::size_t{layer.sample}]) - 1 != layer.layer.row)
        return spread;
    SlopeSpread between;
    for (const bool isDown : {false, true}) {
        const SurfaceDirection bend = layer.axes.of(
            own.change(samples, layer.sample, column, row, isDown, making_.roles.size()));
        between.xx += bend.x * bend.x;
        between.xy += bend.x * bend.y;
        between.yy += bend.y * bend.y;
    }
    return atLeast(between, spread.xx);
}

void LobeQuadrature::addByTable(const Tile& own, const DirectionalLayer& layer,
                                Found& found) const {
    const auto drawn = static_cast<std::size_t>(layer.layer.row);
    const Vec3 view = layer.along * -1.0;
    const Vec3 x = layer.grid.isByAzimuth() ? own.towards : levelOf(view, own.zenith);
    const Vec3 y = crossed(own.zenith, x);
    const auto inTable = [&](const Vec3& v) {
        return Vec3{product(v, x), product(v, y), product(v, own.zenith)};
    };
    const LobeQuadratureTable::About about = LobeQuadratureTable::about(
        inTable(layer.axes.to({-layer.to.x, -layer.to.y, layer.to.z})), divisions_[drawn]);
    found.speculars.push_back({layer.sample, layer.number, layer.rowOf(layer.model.components()),
                               static_cast<std::uint32_t>(drawn),
                               static_cast<std::uint32_t>(found.scales.size()), about.keys,
                               about.weights});
    found.cells.push_back(LobeQuadratureTable::cellOf(inTable(view), layer.grid.isByAzimuth()));
    for (std::size_t k = 0; k < layer.lobes(); ++k)
        found.scales.push_back(static_cast<float>(layer.model.albedo(k, layer.to.z)));
}

void LobeQuadrature::addByFacets(const DirectionalLayer& layer, const Mirrored& mirrored,
                                 Found& found) const {
    for (std::size_t k = 0; k < layer.lobes(); ++k) {
        const double albedo = layer.model.albedo(k, layer.to.z);
        for (const auto& [set, place, parts] : mirrored.atmosphere)
            if (parts[k] != 0.0)
                found.lobes.push_back({layer.sample, layer.number, layer.rowOfAtmosphere(k, place),
                                       0.0f, static_cast<float>(parts[k] * albedo), 0.0f});
        const auto add = [&](int row, double weight, GeometrySamples::Place from, int set) {
            found.reflected.push_back({layer.sample, layer.number, row, static_cast<float>(weight),
                                       from, static_cast<std::uint32_t>(set)});
        };
        for (const auto& [set, number, parts] : mirrored.found.surfaces)
            if (parts[k] != 0.0)
                add(layer.rowOfSurfaces(k), parts[k] * albedo, {number, 0.0f, 0.0f}, set);
        for (const auto& [set, place, parts] : mirrored.found.atmosphere)
            if (parts[k] != 0.0)
                add(layer.rowOfAtmosphere(k, place), parts[k] * albedo, {}, set);
    }
}

void LobeQuadrature::addGasChange(const Tile& own, const DirectionalLayer& layer,
                                  const Mirrored& mirrored, Found& found) {
    const GeometrySamples::Place* const at = layer.layer.place;
    if (own.exchange == nullptr || at == nullptr || at->cell == GeometrySamples::Place::none)
        return;
    for (std::size_t k = 0; k < layer.lobes(); ++k) {
        const double part = mirrored.isOpen ? 1.0 : 1.0 - mirrored.found.elsewhere[k];
        const auto weight = static_cast<float>(part * layer.model.albedo(k, layer.to.z));
        own.exchange->forEachGasChange(at->cell, at->u, at->v, [&](std::uint32_t number, float of) {
            if (weight != 0.0f)
                found.reflected.push_back({layer.sample,
                                           layer.number,
                                           layer.rowOfSurfaces(k),
                                           of * weight,
                                           {number, 0.0f, 0.0f},
                                           0});
        });
    }
}

void LobeQuadrature::addLobes(const Tile& own, int row, int column, const GeometrySamples& samples,
                              SunShadows::Neighbours& neighbours, Found& found) const {
    const std::size_t sample = indexOf(*own.tile, column, row);
    if (samples.isEmpty(sample))
        return;
    const std::size_t first = making_.roles.size();
    const Vec3 along = own.directions.at(column, row);
    std::uint32_t number = 0;
    thread_local Mirrored mirrored;
    samples.forEachLayer(sample, [&](const GeometrySamples::Layer& drawn) {
        const std::uint32_t ofSample = number++;
        const SurfaceModel* const model = making_.models[static_cast<std::size_t>(drawn.row)].get();
        if (model == nullptr)
            return;
        const float* n = drawn.factors.data() + first;
        const Vec3 normal = normalized(
            {static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])});
        const auto entity = static_cast<std::size_t>(rows_.keyOf(drawn.row).first);
        DirectionalLayer layer{drawn,
                               *model,
                               making_.grids[entity],
                               along,
                               SurfaceAxes(normal, along * -1.0),
                               {},
                               static_cast<std::uint32_t>(sample),
                               ofSample,
                               rows_.firstLobe(drawn.row),
                               samples.standsForGroup(sample) ? own.step / 2 : own.step,
                               samples.standsForGroup(sample) ? 2 : 1};
        layer.to = layer.axes.ofSeen(along * -1.0);

        const SurfaceDirection sun = layer.axes.of(own.sun);
        const bool isLit = making_.isSunSmart && sun.z > 0.0;
        // The spread of slopes, with that of the sample and of the sun's disc.
        const SlopeSpread spread =
            isLit ? spreadOf(own, row, column, samples, layer) : SlopeSpread{};
        follow(own, layer, neighbours, column, found.sets, mirrored);
        for (std::size_t k = 0; k < model->components(); ++k) {
            const double albedo = model->albedo(k, layer.to.z), mean = model->meanAlbedo(k);
            const double elsewhere = !model->hasLobe(k) ? 1.0
                                     : mirrored.isOpen  ? 0.0
                                                        : mirrored.found.elsewhere[k];
            const double glint = isLit ? pi * model->brdf_per_sr(k, layer.to, sun, spread)
                                 : making_.isSunSmart ? 0.0
                                                      : albedo;
            found.lobes.push_back(
                {layer.sample, ofSample, layer.rowOf(k), static_cast<float>(albedo - mean),
                 static_cast<float>(elsewhere * albedo - mean), static_cast<float>(glint - mean)});
        }
        if (layer.lobes() == 0)
            return;
        addGasChange(own, layer, mirrored, found);
        if (mirrored.isOpen || mirrored.isBesideTable)
            addByTable(own, layer, found);
        if (!mirrored.isOpen)
            addByFacets(layer, mirrored, found);
    });
}

/// The tables that a drawing uses.
class LobeQuadrature::TableUse {
  public:
    TableUse(const Making& making, const SurfaceRows& rows) : making_(making), rows_(rows) {}

    /// Of a drawn row and a direction of view, and its number here.
    std::pair<std::uint32_t, LobeQuadratureTable*> of(std::uint32_t drawn,
                                                      LobeQuadratureTable::ViewCell cell) {
        if (last_.second != nullptr && drawn == lastDrawn_ && cell == lastCell_)
            return last_;
        lastDrawn_ = drawn;
        lastCell_ = cell;
        const auto entity = static_cast<std::size_t>(rows_.keyOf(static_cast<int>(drawn)).first);
        const std::shared_ptr<LobeQuadratureTable> table =
            making_.tables->of(making_.models[drawn], making_.grids[entity], cell);
        auto known = std::ranges::find(tables_, table);
        if (known == tables_.end())
            known = tables_.insert(known, table);
        return last_ = {static_cast<std::uint32_t>(known - tables_.begin()), table.get()};
    }
    const std::vector<std::shared_ptr<LobeQuadratureTable>>& tables() const { return tables_; }

  private:
    const Making& making_;
    const SurfaceRows& rows_;
    std::vector<std::shared_ptr<LobeQuadratureTable>> tables_;
    std::uint32_t lastDrawn_ = 0;
    LobeQuadratureTable::ViewCell lastCell_;
    std::pair<std::uint32_t, LobeQuadratureTable*> last_{0, nullptr};
};

void LobeQuadrature::apply(const SheetScene& sheet, const SunShadows* shadows,
                           const LightExchange* exchange, const LobeAims* aims,
                           GeometrySamples& samples) const {
    samples.lobes.clear();
    samples.reflected.clear();
    samples.reflectedSets.clear();
    samples.speculars.clear();
    samples.specularScales.clear();
    samples.specularTables.clear();
    samples.lobeRoles = making_.roles;
    std::vector<Tile> tiles;
    // As many rays for each sample as so many in all allow.
    const std::size_t step =
        std::clamp<std::size_t>(samples.size() / samplesOfAllFacets, 1, mostStep);
    for (std::size_t w = 0; w < sheet.scenes.size(); ++w) {
        Tile& own = tiles.emplace_back();
        own.step = step;
        own.scene = &sheet.scenes[w];
        own.tile = &sheet.sheet.tiles[w];
        own.directions = {own.scene->camera->sensor(), *own.tile};
        const auto& directions = own.scene->factors.directionsEye;
        if (making_.zenith >= 0)
            own.zenith = directions[static_cast<std::size_t>(making_.zenith)].second;
        if (making_.sun >= 0)
            own.sun = directions[static_cast<std::size_t>(making_.sun)].second;
        own.towards = levelOf(own.sun, own.zenith);
        own.exchange = exchange;
        if (shadows == nullptr || exchange == nullptr)
            continue;
        own.open = shadows->openPaths(*own.scene, *own.tile);
        own.aims = aims;
        if (aims == nullptr)
            continue;
        for (const LobeAims::Sphere& sphere : aims->spheres()) {
            const auto entity = static_cast<std::size_t>(exchange->bodies()[sphere.body].entity);
            own.aimsAt_m.push_back(shadows->casters()[entity].pose.toWorld(sphere.centre_m));
        }
    }
    const std::vector<TileRows> pieces = rowsOf(sheet.sheet);
    std::vector<Found> found(pieces.size());
    struct Line { // of a tile: its lobes stand by sample and layer already
        std::size_t piece = 0, begin = 0, end = 0, firstSpecular = 0, lastSpecular = 0;
        std::size_t firstReflected = 0, lastReflected = 0;
    };
    std::vector<std::vector<Line>> linesOf(pieces.size());
    parallelFor(pieces.size(), [&](std::size_t i) {
        const Tile& own = tiles[pieces[i].tile];
        SunShadows::Neighbours neighbours;
        Found& piece = found[i];
        for (int row = pieces[i].first; row < pieces[i].last; ++row) {
            const std::size_t begin = piece.lobes.size(), firstSpecular = piece.speculars.size();
            const std::size_t firstReflected = piece.reflected.size();
            for (int column = 0; column < own.tile->width(); ++column)
                addLobes(own, row, column, samples, neighbours, piece);
            if (piece.lobes.size() > begin)
                linesOf[i].push_back({i, begin, piece.lobes.size(), firstSpecular,
                                      piece.speculars.size(), firstReflected,
                                      piece.reflected.size()});
        }
    });
    std::vector<Line> lines;
    for (const std::vector<Line>& some : linesOf)
        lines.insert(lines.end(), some.begin(), some.end());
    std::ranges::sort(lines, {},
                      [&](const Line& line) { return found[line.piece].lobes[line.begin].sample; });
    std::size_t lobes = 0, speculars = 0;
    for (const Line& line : lines) {
        lobes += line.end - line.begin;
        speculars += line.lastSpecular - line.firstSpecular;
    }
    samples.lobes.reserve(lobes);
    samples.speculars.reserve(speculars);
    TableUse use(making_, rows_);
    OccluderStacks sets;
    for (const Line& line : lines) {
        Found& piece = found[line.piece];
        samples.lobes.insert(samples.lobes.end(), piece.lobes.data() + line.begin,
                             piece.lobes.data() + line.end);
        for (std::size_t i = line.firstReflected; i < line.lastReflected; ++i) {
            GeometrySamples::Reflected& one = piece.reflected[i];
            if (one.from.cell != GeometrySamples::Place::none)
                one.from.cell = exchange->cellOfReflected(one.from.cell);
            one.set = static_cast<std::uint32_t>(
                one.set == 0 ? 0 : sets.numberOf(piece.sets.materials(static_cast<int>(one.set))));
            samples.reflected.push_back(one);
        }
        for (std::size_t i = line.firstSpecular; i < line.lastSpecular; ++i) {
            GeometrySamples::Specular mirror = piece.speculars[i];
            if (static_cast<std::size_t>(mirror.row) >= rows_.renderedCount())
                throw LogicError("a surface mirrors the air in a row that there is not");
            const auto [number, table] = use.of(mirror.table, piece.cells[i]);
            const float* scales = &piece.scales[mirror.scales];
            mirror.table = number;
            mirror.scales = static_cast<std::uint32_t>(samples.specularScales.size());
            samples.specularScales.insert(samples.specularScales.end(), scales,
                                          scales + table->components);
            for (std::uint32_t& node : mirror.nodes)
                node = table->nodeOf(node);
            samples.speculars.push_back(mirror);
        }
    }
    for (std::size_t set = 0; set < sets.size(); ++set)
        samples.reflectedSets.push_back(sets.materials(static_cast<int>(set)));
    for (const std::shared_ptr<LobeQuadratureTable>& table : use.tables()) {
        table->fill();
        samples.specularTables.push_back(table);
    }
    samples.factorCount = making_.roles.size();
}

} // namespace irsg
