#include "irsg/radiance/LobeQuadrature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiance/LobePaths.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/TileSamples.h"

namespace irsg {

namespace {

/// Of so many samples each follows all of its facets to what they reflect; of more, one in a few,
/// in turn.
constexpr std::size_t samplesOfAllFacets = 20'000, mostStep = 6;
/// Neighbours whose normals differ by more are those of another face.
constexpr double mostBend = 0.5;

/// The level part of a direction as a unit vector; of a vertical one any level one.
Vec3 levelOf(const Vec3& direction, const Vec3& zenith) {
    const Vec3 level = direction - zenith * product(direction, zenith);
    const double size = plainLength(level);
    if (size > 1e-9)
        return level * (1.0 / size);
    return normalized(cross(std::abs(zenith.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, zenith));
}

} // namespace

/// Of a drawing.
struct LobeQuadrature::Tile {
    const SurfaceScene* scene = nullptr;
    const SampleTile* tile = nullptr;
    EyeDirections directions;
    Vec3 zenith, sun, towards; ///< the last the level part of the sun's, a unit vector
    std::optional<SunShadows::OpenPaths> open;
    const LightExchange* exchange = nullptr; ///< there where `open` is
    std::size_t step = 1;                    ///< of the facets that a sample follows one in so many

    /// The normal of the opaque surface of a sample, and its row + 1; 0 for none.
    static std::pair<float, Vec3> opaqueAt(const GeometrySamples& samples, std::size_t sample,
                                           std::size_t first) {
        const auto number = [&](std::size_t f) {
            return static_cast<double>(f < 3 ? samples.opaque[4 * sample + 1 + f]
                                             : samples.moreFactors[4 * sample + f - 3]);
        };
        return {samples.opaque[4 * sample], {number(first), number(first + 1), number(first + 2)}};
    }
    /// How the normal changes from sample to sample along rows or columns, from the side that
    /// bends less.
    Vec3 change(const GeometrySamples& samples, std::size_t sample, int column, int row,
                bool isDown, std::size_t first) const {
        const auto [own, normal] = opaqueAt(samples, sample, first);
        Vec3 least;
        double square = mostBend * mostBend;
        for (const int step : {-1, 1}) {
            const int x = column + (isDown ? 0 : step), y = row + (isDown ? step : 0);
            if (x < 0 || y < 0 || x >= tile->width() || y >= tile->height())
                continue;
            const auto [other, next] = opaqueAt(samples, indexOf(*tile, x, y), first);
            const Vec3 difference = next - normal;
            if (other == own && product(difference, difference) < square) {
                square = product(difference, difference);
                least = difference;
            }
        }
        return least;
    }
};

/// Of a piece of the samples.
struct LobeQuadrature::Found {
    std::vector<GeometrySamples::Lobe> lobes;
    std::vector<GeometrySamples::Reflected> reflected;
    std::vector<GeometrySamples::Specular> speculars; // nodes as keys, `table` as drawn row
    std::vector<LobeQuadratureTable::ViewCell> cells; // of each of those
    std::vector<float> scales;
    OccluderStacks sets; // of what is reflected
};

/// The places of a grid about a direction in eye space, and their parts.
std::array<std::pair<std::size_t, double>, 4>
LobeQuadrature::placesAbout(const Tile& own, const SpecularEnvironmentGrid& grid,
                            const Vec3& direction) {
    const double up = std::clamp(product(direction, own.zenith), -1.0, 1.0);
    double fromSun = 0.0;
    if (grid.isByAzimuth()) {
        const Vec3 flat = direction - own.zenith * up;
        const double size = plainLength(flat);
        if (size > 1e-9)
            fromSun = std::acos(std::clamp(product(flat, own.towards) / size, -1.0, 1.0));
    }
    return grid.about(std::asin(up), fromSun);
}

/// A layer of a directional surface.
struct LobeQuadrature::DirectionalLayer {
    const GeometrySamples::Layer& layer;
    const SurfaceModel& model;
    const SpecularEnvironmentGrid& grid;
    Vec3 along; ///< from the eye
    SurfaceAxes axes;
    SurfaceDirection to;
    std::uint32_t sample = 0, number = 0; ///< number among those of the sample
    int firstLobe = 0;                    ///< row

    std::size_t lobes() const {
        std::size_t count = 0;
        while (count < model.components() && model.hasLobe(count))
            ++count;
        return count;
    }
    int rowOf(std::size_t component) const { return firstLobe + static_cast<int>(component); }
    int rowOfAtmosphere(std::size_t component, std::size_t place) const {
        return rowOf(model.components() + component * grid.places().size() + place);
    }
    int rowOfSurfaces(std::size_t component) const {
        return rowOf(model.components() + lobes() * grid.places().size() + component);
    }
};

/// What the lobes of a layer meet, in parts of their albedos.
struct LobeQuadrature::Mirrored {
    bool isOpen = false;                     ///< all meet the atmosphere; no more is told
    std::vector<LobePaths::Part> atmosphere; ///< by place of the grid, through nothing
    LobePaths::Found found;                  ///< and what else there is of the atmosphere

    void clear() {
        isOpen = false;
        atmosphere.clear();
        found.clear();
    }
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
    for (const bool isDown : {false, true}) {
        const SurfaceDirection bend = layer.axes.of(
            own.change(samples, layer.sample, column, row, isDown, making_.roles.size()));
        spread.xx += 2.0 * bend.x * bend.x;
        spread.xy += 2.0 * bend.x * bend.y;
        spread.yy += 2.0 * bend.y * bend.y;
    }
    return spread;
}

void LobeQuadrature::follow(const Tile& own, const DirectionalLayer& layer,
                            SunShadows::Neighbours& neighbours, int column, OccluderStacks& sets,
                            Mirrored& mirrored) const {
    const std::size_t places = layer.grid.places().size(), lobes = layer.lobes();
    mirrored.clear();
    const SurfaceDirection mirror{-layer.to.x, -layer.to.y, layer.to.z};
    std::optional<SunShadows::Place> from;
    if (own.open) {
        from = own.open->placeOf(layer.along, layer.layer.row,
                                 static_cast<double>(layer.layer.distance_m), column, neighbours);
        const GeometrySamples::Place* const at = layer.layer.place;
        const bool isKnown = at != nullptr && at->cell != GeometrySamples::Place::none;
        const std::array<float, 3> open =
            isKnown ? own.exchange->openAt(at->cell) : std::array<float, 3>{1.0f, 1.0f, 1.0f};
        constexpr float rounding = 1e-6f;
        mirrored.isOpen = *std::ranges::min_element(open) > 1.0f - rounding &&
                          own.open->isOpen(*from, layer.axes.to(mirror));
    } else {
        mirrored.isOpen = true;
    }
    // Where nothing is known of the atmosphere by direction, it counts on the whole; where surfaces
    // are followed, there is none.
    if (mirrored.isOpen && places == 0) {
        mirrored.isOpen = false;
        mirrored.found.elsewhere.fill(own.open ? 0.0 : 1.0);
        return;
    }
    if (mirrored.isOpen && layer.model.facets().size() > 1 &&
        LobeQuadratureTable::serves(layer.model))
        return;

    const bool isFree = mirrored.isOpen;
    mirrored.isOpen = false;
    // Samples turn facets differently, so that few rays of each do for all (Roberts' sequence).
    const auto partOf = [&](double step) {
        const double turned = step * static_cast<double>(layer.sample % 65536u);
        return isFree ? 0.0 : turned - std::floor(turned);
    };
    const double share = isFree ? 0.5 : partOf(0.7548776662466927);
    const double turn = partOf(0.5698402909980532);
    const std::size_t facets = layer.model.facets().size();
    const std::size_t step = isFree ? 1 : std::min(own.step, facets);
    const auto first =
        static_cast<std::size_t>(partOf(0.6180339887498949) * static_cast<double>(step));
    SurfaceModel::Amounts followed{};
    LobePaths::Found& found = mirrored.found;
    LobePaths paths(sets);
    const LobePaths::Making making{
        &rows_,  &making_.models,   &making_.mirrors, own.exchange, own.open ? &*own.open : nullptr,
        own.sun, making_.isSunSmart};
    thread_local LobePaths::Ray ray;
    for (std::size_t i = first; i < facets; i += step) {
        const SurfaceDirection facet = layer.model.facet(i, share, turn);
        const SurfaceModel::Amounts sent = layer.model.facetWeights(layer.to, facet);
        if (std::ranges::all_of(sent, [](double weight) { return weight == 0.0; }))
            continue;
        for (std::size_t k = 0; k < lobes; ++k)
            followed[k] += sent[k];
        ray.direction = layer.axes.to(irsg::mirrored(layer.to, facet));
        ray.met = SunShadows::Met::nothing;
        ray.panes.clear();
        if (!isFree)
            ray.met = own.open->met(*from, ray.direction, ray.end, ray.panes);
        if (LobePaths::goesOn(making, ray, layer.layer.row)) {
            const double other = share + 0.7548776662466927 * static_cast<double>(i + 1);
            paths.follow(
                making, ray, layer.layer.row, sent, other - std::floor(other),
                [&](const Vec3& direction, const auto& visit) {
                    if (places == 0)
                        return;
                    for (const auto& [place, part] : placesAbout(own, layer.grid, direction))
                        visit(place, part);
                },
                found);
            continue;
        }
        for (std::size_t k = 0; k < lobes && ray.met == SunShadows::Met::other; ++k)
            found.elsewhere[k] += sent[k];
        const GeometrySamples::Place& at = ray.end.at;
        if (ray.met == SunShadows::Met::surface)
            own.exchange->forEachReflected(
                at.cell, at.u, at.v, [&](std::uint32_t number, float part) {
                    LobePaths::add(found.surfaces, 0, number, sent, static_cast<double>(part));
                });
        if (ray.met == SunShadows::Met::nothing && places > 0)
            for (const auto& [place, part] : placesAbout(own, layer.grid, ray.direction))
                LobePaths::add(mirrored.atmosphere, 0, static_cast<std::uint32_t>(place), sent,
                               part);
    }
    found.join();
    LobePaths::join(mirrored.atmosphere);
    const std::array all{&mirrored.atmosphere, &found.surfaces, &found.atmosphere};
    for (std::size_t k = 0; k < lobes; ++k) {
        // What all facets send: followed ones, or the mean over samples, each of which stands for
        // `step` facets of it.
        const double sent =
            step == 1 ? followed[k] : layer.model.sent(k, layer.to.z) * static_cast<double>(facets);
        if (sent == 0.0) { // no facet that stands for others faces the eye
            found.elsewhere[k] = 1.0;
            for (std::vector<LobePaths::Part>* parts : all)
                for (LobePaths::Part& one : *parts)
                    one.weights[k] = 0.0;
            continue;
        }
        // What these are more or less than all sees the mean, so that energy closes; over samples
        // that adds up to nothing.
        const double scale = static_cast<double>(step) / sent;
        found.elsewhere[k] = scale * found.elsewhere[k] + 1.0 - scale * followed[k];
        for (std::vector<LobePaths::Part>* parts : all)
            for (LobePaths::Part& one : *parts)
                one.weights[k] *= scale;
    }
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
                               rows_.firstLobe(drawn.row)};
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
        if (mirrored.isOpen)
            addByTable(own, layer, found);
        else
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
                           const LightExchange* exchange, GeometrySamples& samples) const {
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
        if (shadows != nullptr && exchange != nullptr)
            own.open = shadows->openPaths(*own.scene, *own.tile);
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
