#include "irsg/scene/PixelExplainer.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/radiance/PixelTerms.h"
#include "irsg/render/rays/RayEngine.h"
#include "irsg/render/rays/TileRays.h"
#include "irsg/render/rays/TileSamples.h"
#include "irsg/render/sampling/OffAxisShares.h"
#include "irsg/render/sampling/SampleSheet.h"

namespace irsg {

namespace {

/// The samples of a tile that belong to a pixel.
std::vector<SampleRun> runsOf(const SampleTile& tile, const PixelGrid& grid, int x, int y) {
    const auto blockOf = [&](int pixel) {
        return std::clamp<std::int64_t>(
            (static_cast<std::int64_t>(pixel) << tile.level) - tile.blockY, 0, tile.blocksHigh);
    };
    const int first = static_cast<int>(blockOf(y)) * tile.samplesDown;
    const int last = static_cast<int>(blockOf(y + 1)) * tile.samplesDown;
    std::vector<SampleRun> runs;
    const OffAxisShares shares(tile, grid);
    shares.forEachRun(
        first, last, [&](std::size_t sample, int count, int column, int, double weight, double) {
            if (column != x)
                return;
            runs.push_back({tile.rowOf(sample),
                            static_cast<int>((sample - tile.firstSample) % tile.stride()), count,
                            weight});
        });
    return runs;
}

/// Those samples with all beside them in a drawing, whose normals say how wide lobes are: one run a
/// row.
std::vector<SampleRun> withNeighbours(const std::vector<SampleRun>& runs, const SampleTile& tile) {
    std::map<int, std::pair<int, int>> columns; // by row: the first, and that after the last
    for (const SampleRun& run : runs)
        for (int row = std::max(run.row - 1, 0); row < std::min(run.row + 2, tile.height());
             ++row) {
            const int first = std::max(run.firstColumn - 1, 0);
            const int end = std::min(run.firstColumn + run.count + 1, tile.width());
            const auto [known, isNew] = columns.try_emplace(row, first, end);
            if (!isNew)
                known->second = {std::min(known->second.first, first),
                                 std::max(known->second.second, end)};
        }
    std::vector<SampleRun> all;
    all.reserve(columns.size());
    for (const auto& [row, range] : columns)
        all.push_back({row, range.first, range.second - range.first, 1.0});
    return all;
}

} // namespace

PixelExplanation PixelExplainer::at(int x, int y) {
    const Frame& frame = frame_;
    const Sensor& sensor = frame.sensor();
    if (x < 0 || y < 0 || x >= sensor.width_px || y >= sensor.height_px)
        throw LogicError("a pixel outside the frame was to be explained");
    // Frames share evaluated scenes, and another may have been drawn since.
    EvaluatedScene& evaluated = frame.evaluation().turned(frame.scene().entities);

    PixelExplanation result;
    result.x = x;
    result.y = y;
    result.background_W_m2_sr = background_.at(x, y);
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(sensor.width_px) +
        static_cast<std::size_t>(x);
    const auto part = [&](const std::vector<double>& values, std::optional<double>& into) {
        if (pixel < values.size())
            into = values[pixel];
    };
    part(frame.backgrounds.layers.sky, result.sky_W_m2_sr);
    part(frame.backgrounds.layers.environment, result.environment_W_m2_sr);
    part(frame.backgrounds.layers.terrain, result.terrain_W_m2_sr);
    if (const double drawn = frame.backgrounds.byOutput.front().at(x, y);
        result.environment_W_m2_sr && drawn > 0.0)
        *result.environment_W_m2_sr *= result.background_W_m2_sr / drawn;

    // The facets of the middles of the pixels around.
    std::optional<std::vector<TileRays::Facet>> facets;
    result.isInterior = true;
    const auto compare = [&](std::vector<TileRays::Facet> met) {
        if (!facets)
            facets = std::move(met);
        else if (*facets != met)
            result.isInterior = false;
    };
    SampleTile around;
    around.blockX = x - 1;
    around.blockY = y - 1;
    around.blocksWide = around.blocksHigh = 3;
    for (const ObjectExtent& object : frame.plan.seen)
        around.entities.push_back(object.entity);
    std::ranges::sort(around.entities);
    SurfaceScene scene = surfaces_.sceneOf(frame.surfaces, frame.request.camera, around);
    if (const auto& terrain = frame.scene().terrain; terrain && !scene.terrain.rays)
        scene.terrain = terrain->bodyFor(frame.request.camera, terrainRays_.meshOf(terrain));
    const TileRays middles(scene, around);
    for (int i = 0; i < 9; ++i)
        compare(middles.facetsAt(i % 3, i / 3));

    // The samples that the image takes of the pixel.
    PixelTerms terms(evaluated.radiometry, evaluated.radiances, occluderStacks_, frame.light(),
                     background_.behindAt(x, y));
    const PixelGrid grid(sensor);
    for (const SampleSheet& sheet : sheets_) {
        std::optional<SheetScene> drawn;
        for (std::size_t w = 0; w < sheet.tiles.size(); ++w) {
            const SampleTile& tile = sheet.tiles[w];
            const std::vector<SampleRun> runs = runsOf(tile, grid, x, y);
            if (runs.empty())
                continue;
            if (!drawn)
                drawn = surfaces_.scenesOf(frame.surfaces, frame.request.camera, sheet);
            GeometrySamples& samples = samples_;
            RayEngine::traceRuns(
                *drawn, w, frame.shading().isNeeded() ? withNeighbours(runs, tile) : runs, samples);
            frame.shading().sortAndApply(*drawn, frame.settings(), samples);
            const TileRays rays(drawn->scenes[w], tile);
            for (const SampleRun& run : runs)
                for (int column = run.firstColumn; column < run.firstColumn + run.count; ++column) {
                    const std::size_t sample =
                        samples.standingFor(indexOf(tile, column, run.row), tile.stride());
                    ++result.samples;
                    if (result.isInterior)
                        compare(rays.facetsAt(column, run.row));
                    if (samples.isEmpty(sample))
                        continue;
                    result.layersLeftOver += samples.isLeftOver(sample) ? 1 : 0;
                    terms.add(samples, sample, tile.share() * run.weight);
                }
        }
    }
    for (const ObjectExtent& object : frame.plan.points) {
        const PointPlace place = AspectSampler::placeOf(frame, object);
        if (place.x != x || place.y != y)
            continue;
        const PointGeometry& factors = aspects_.pointGeometry(frame, object);
        terms.addPoint(factors, 1.0 / (place.distance_m * place.distance_m * place.solidAngle_sr),
                       place.distance_m);
        result.isInterior = false;
        result.remarks.push_back("'" + frame.request.entity(object.entity).name +
                                 "' is so small that all of it is in this pixel, as a point");
        if (frame.light())
            result.remarks.push_back("its inter-reflection is not explained");
    }

    result.surfaces = terms.surfaces(frame.scene().entities);
    result.backgroundLeft_W_m2_sr = result.background_W_m2_sr;
    for (const ExplainedSurface& surface : result.surfaces) {
        result.backgroundLeft_W_m2_sr -= surface.hidden_W_m2_sr;
        result.radiance_W_m2_sr += surface.radiance_W_m2_sr;
    }
    result.radiance_W_m2_sr += result.backgroundLeft_W_m2_sr;
    if (pixel < frame.backgrounds.layers.coverage.size() &&
        frame.backgrounds.layers.coverage[pixel] > 0.0)
        result.remarks.push_back("OpenGL interpolates the terrain's texture less exactly than it "
                                 "is done here, by some 1e-4 of the picture");
    if (frame.settings().scattering)
        result.remarks.push_back("the haze that droplets add to the image is not explained");
    if (frame.settings().usesPublishedTiles())
        result.remarks.push_back("the antialiasing as published resamples what it draws; these are "
                                 "samples of the pixel");
    return result;
}

} // namespace irsg
