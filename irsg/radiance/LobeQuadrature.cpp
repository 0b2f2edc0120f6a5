#include "irsg/radiance/LobeQuadrature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/TileSamples.h"

namespace irsg {

namespace {

/// Mean square of the sun's disc along an axis, for half vectors, which turn by half: twice that is
/// what it adds to the spread of slopes.
constexpr double discSpread = SunShadows::discRadius_rad * SunShadows::discRadius_rad / 8.0;
/// Neighbours whose normals differ by more are those of another face.
constexpr double mostBend = 0.5;

/// The axes of a surface: its normal, and one in the plane of view.
struct Axes {
    Vec3 x, y, z;
    Axes(const Vec3& normal, const Vec3& view) : z(normal) {
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
    SurfaceDirection of(const Vec3& v) const {
        return {product(v, x), product(v, y), product(v, z)};
    }
    Vec3 to(const SurfaceDirection& v) const { return x * v.x + y * v.y + z * v.z; }
};

/// The level part of a direction as a unit vector; of a vertical one any level one.
Vec3 levelOf(const Vec3& direction, const Vec3& zenith) {
    const Vec3 level = direction - zenith * product(direction, zenith);
    const double size = plainLength(level);
    if (size > 1e-9)
        return level * (1.0 / size);
    return normalized(cross(std::abs(zenith.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, zenith));
}

} // namespace

struct LobeQuadrature::Tile {
    const SurfaceScene* scene = nullptr;
    const SampleTile* tile = nullptr;
    EyeDirections directions;
    Vec3 zenith, sun, towards; ///< the last the level part of the sun's, a unit vector
    std::optional<SunShadows::OpenPaths> open;

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
    std::vector<GeometrySamples::Specular> speculars; // nodes as keys, `table` as drawn row
    std::vector<LobeQuadratureTable::ViewCell> cells; // of each of those
    std::vector<float> scales;
};

LobeQuadrature::LobeQuadrature(const SurfaceRows& rows, Making making)
    : rows_(rows), making_(std::move(making)) {
    for (const auto& model : making_.models)
        divisions_.push_back(model && LobeQuadratureTable::serves(*model)
                                 ? LobeQuadratureTable::divisionsOf(*model)
                                 : 0);
}

void LobeQuadrature::addLobes(const Tile& own, int row, int column, const GeometrySamples& samples,
                              SunShadows::Neighbours& neighbours, Found& found) const {
    const std::size_t sample = indexOf(*own.tile, column, row);
    if (samples.isEmpty(sample))
        return;
    const std::size_t first = making_.roles.size();
    const Vec3 along = own.directions.at(column, row);
    std::uint32_t number = 0;
    samples.forEachLayer(sample, [&](const GeometrySamples::Layer& layer) {
        const std::uint32_t ofSample = number++;
        const auto drawn = static_cast<std::size_t>(layer.row);
        const SurfaceModel* model = making_.models[drawn].get();
        if (model == nullptr)
            return;
        const float* n = layer.factors.data() + first;
        const Vec3 normal = normalized(
            {static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])});
        const Vec3 view = along * -1.0;
        const Axes axes(normal, view);
        SurfaceDirection to = axes.of(view);
        to.z = std::max(to.z, 1e-4); // interpolated normals may look away

        // The spread of slopes, with that of the sample and of the sun's disc.
        const SurfaceDirection sun = axes.of(own.sun);
        const bool isLit = making_.isSunSmart && sun.z > 0.0;
        SlopeSpread spread = SlopeSpread::of(model->roughness());
        spread.xx += discSpread;
        spread.yy += discSpread;
        const bool isOpaque = samples.isOpaque(sample) &&
                              static_cast<int>(samples.opaque[4 * sample]) - 1 == layer.row;
        for (const bool isDown : {false, true}) {
            if (!isOpaque || !isLit)
                break;
            const SurfaceDirection bend =
                axes.of(own.change(samples, sample, column, row, isDown, first));
            spread.xx += 2.0 * bend.x * bend.x;
            spread.xy += 2.0 * bend.x * bend.y;
            spread.yy += 2.0 * bend.y * bend.y;
        }

        const std::size_t components = model->components();
        const auto entity = static_cast<std::size_t>(rows_.keyOf(layer.row).first);
        const SpecularEnvironmentGrid& grid = making_.grids[entity];
        const std::size_t places = grid.places().size();
        double open = 0.0;
        if (places > 0) {
            const SurfaceDirection mirror{-to.x, -to.y, to.z};
            open = !own.open ||
                           own.open->isOpen(along, layer.row, static_cast<double>(layer.distance_m),
                                            axes.to(mirror), column, neighbours)
                       ? 1.0
                       : 0.0;
        }
        const auto firstLobe = static_cast<std::size_t>(rows_.firstLobe(layer.row));
        const auto add = [&](std::size_t lobe, double emission, double flux, double ofSun) {
            found.lobes.push_back({static_cast<std::uint32_t>(sample), ofSample,
                                   static_cast<int>(firstLobe + lobe), static_cast<float>(emission),
                                   static_cast<float>(flux), static_cast<float>(ofSun)});
        };
        for (std::size_t k = 0; k < components; ++k) {
            const double albedo = model->albedo(k, to.z), mean = model->meanAlbedo(k);
            const double hidden = model->hasLobe(k) ? 1.0 - open : 1.0;
            const double glint = isLit                ? pi * model->brdf_per_sr(k, to, sun, spread)
                                 : making_.isSunSmart ? 0.0
                                                      : albedo;
            add(k, albedo - mean, hidden * albedo - mean, glint - mean);
        }
        if (open == 0.0 || components == 0 || !model->hasLobe(0))
            return; // hidden, or no component lies in a lobe

        // Where the lobe lies in the world.
        if (const std::uint32_t divisions = divisions_[drawn]; divisions > 0) {
            const Vec3 x = grid.isByAzimuth() ? own.towards : levelOf(view, own.zenith);
            const Vec3 y = crossed(own.zenith, x);
            const auto inTable = [&](const Vec3& v) {
                return Vec3{product(v, x), product(v, y), product(v, own.zenith)};
            };
            const LobeQuadratureTable::About about =
                LobeQuadratureTable::about(inTable(axes.to({-to.x, -to.y, to.z})), divisions);
            found.speculars.push_back(
                {static_cast<std::uint32_t>(sample), ofSample,
                 static_cast<int>(firstLobe + components), static_cast<std::uint32_t>(drawn),
                 static_cast<std::uint32_t>(found.scales.size()), about.keys, about.weights});
            found.cells.push_back(LobeQuadratureTable::cellOf(inTable(view), grid.isByAzimuth()));
            for (std::size_t k = 0; k < components && model->hasLobe(k); ++k)
                found.scales.push_back(static_cast<float>(open * model->albedo(k, to.z)));
            return;
        }
        thread_local std::vector<double> weights;
        const Vec3& towards = own.towards;
        weights.assign(SurfaceModel::mostComponents * places, 0.0);
        std::array<double, SurfaceModel::mostComponents> sums{};
        for (const SurfaceDirection& facet : model->facets()) {
            const Vec3 from = axes.to(mirrored(to, facet));
            const double up = std::clamp(product(from, own.zenith), -1.0, 1.0);
            double fromSun = 0.0;
            if (grid.isByAzimuth()) {
                const Vec3 flat = from - own.zenith * up;
                const double size = plainLength(flat);
                if (size > 1e-9)
                    fromSun = std::acos(std::clamp(product(flat, towards) / size, -1.0, 1.0));
            }
            std::optional<std::array<std::pair<std::size_t, double>, 4>> about;
            const SurfaceModel::Amounts sent = model->facetWeights(to, facet);
            for (std::size_t k = 0; k < components && model->hasLobe(k); ++k) {
                const double weight = sent[k];
                if (weight == 0.0)
                    continue;
                if (!about)
                    about = grid.about(std::asin(up), fromSun);
                sums[k] += weight;
                for (const auto& [place, part] : *about)
                    weights[k * places + place] += weight * part;
            }
        }
        for (std::size_t k = 0; k < components && model->hasLobe(k); ++k) {
            if (sums[k] == 0.0) { // no facet that stands for others faces the eye
                add(k, 0.0, open * model->albedo(k, to.z), 0.0);
                continue;
            }
            const double scale = open * model->albedo(k, to.z) / sums[k];
            for (std::size_t place = 0; place < places; ++place)
                if (const double weight = weights[k * places + place]; weight != 0.0)
                    add(components + k * places + place, 0.0, scale * weight, 0.0);
        }
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
                           GeometrySamples& samples) const {
    samples.lobes.clear();
    samples.speculars.clear();
    samples.specularScales.clear();
    samples.specularTables.clear();
    samples.lobeRoles = making_.roles;
    std::vector<Tile> tiles;
    for (std::size_t w = 0; w < sheet.scenes.size(); ++w) {
        Tile& own = tiles.emplace_back();
        own.scene = &sheet.scenes[w];
        own.tile = &sheet.sheet.tiles[w];
        own.directions = {own.scene->camera->sensor(), *own.tile};
        const auto& directions = own.scene->factors.directionsEye;
        if (making_.zenith >= 0)
            own.zenith = directions[static_cast<std::size_t>(making_.zenith)].second;
        if (making_.sun >= 0)
            own.sun = directions[static_cast<std::size_t>(making_.sun)].second;
        own.towards = levelOf(own.sun, own.zenith);
        if (shadows != nullptr)
            own.open = shadows->openPaths(*own.scene, *own.tile);
    }
    const std::vector<TileRows> pieces = rowsOf(sheet.sheet);
    std::vector<Found> found(pieces.size());
    struct Line { // of a tile: its lobes stand by sample and layer already
        std::size_t piece = 0, begin = 0, end = 0, firstSpecular = 0, lastSpecular = 0;
    };
    std::vector<std::vector<Line>> linesOf(pieces.size());
    parallelFor(pieces.size(), [&](std::size_t i) {
        const Tile& own = tiles[pieces[i].tile];
        SunShadows::Neighbours neighbours;
        Found& piece = found[i];
        for (int row = pieces[i].first; row < pieces[i].last; ++row) {
            const std::size_t begin = piece.lobes.size(), firstSpecular = piece.speculars.size();
            for (int column = 0; column < own.tile->width(); ++column)
                addLobes(own, row, column, samples, neighbours, piece);
            if (piece.lobes.size() > begin)
                linesOf[i].push_back(
                    {i, begin, piece.lobes.size(), firstSpecular, piece.speculars.size()});
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
    for (const Line& line : lines) {
        Found& piece = found[line.piece];
        samples.lobes.insert(samples.lobes.end(), piece.lobes.data() + line.begin,
                             piece.lobes.data() + line.end);
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
    for (const std::shared_ptr<LobeQuadratureTable>& table : use.tables()) {
        table->fill();
        samples.specularTables.push_back(table);
    }
    samples.factorCount = making_.roles.size();
}

} // namespace irsg
