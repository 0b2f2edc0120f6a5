#include "irsg/render/rays/RayEngine.h"

#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/core/Stopwatch.h"
#include "irsg/render/rays/RayMesh.h"
#include "irsg/render/rays/TileRays.h"
#include "irsg/render/rays/TileSamples.h"
#include "irsg/render/sampling/LayerSort.h"

namespace irsg {

namespace {

/// Samples of a sheet that meet nothing.
void makeRoom(const SheetScene& sheet, bool withDistance, GeometrySamples& samples) {
    const std::size_t factorCount = sheet.scenes.front().factors.factorCount;
    samples.width = sheet.sheet.width;
    samples.height = sheet.sheet.height;
    samples.factorCount = factorCount;
    samples.wordsPerFragment = 4 * (1 + (factorCount + 3) / 4);
    const std::size_t count =
        static_cast<std::size_t>(samples.width) * static_cast<std::size_t>(samples.height);
    samples.forgetLight();
    samples.gasesAboutEye = sheet.gasesAboutEye();
    samples.opaque.assign(4 * count, 0.0f);
    samples.moreFactors.assign(factorCount > 3 ? 4 * count : 0, 0.0f);
    samples.distances_m.assign(withDistance ? count : 0, 0.0f);
}

void gather(const std::vector<std::vector<float>>& lists, GeometrySamples& samples) {
    std::size_t words = 0;
    for (const std::vector<float>& list : lists)
        words += list.size();
    std::vector<float> all;
    all.reserve(words);
    for (const std::vector<float>& list : lists)
        all.insert(all.end(), list.begin(), list.end());
    gatherFragments(all, samples);
}

} // namespace

std::future<void> RayEngine::post(std::function<void()> work) {
    return thread_.post(std::move(work));
}

std::string RayEngine::description() const {
    return "rays, " + raysDescription();
}

int RayEngine::largestSide() const {
    return largestDrawing;
}

double RayEngine::takeRenderSeconds() {
    return std::exchange(renderSeconds_, 0.0);
}

void RayEngine::sampleGeometry(const SheetScene& sheet, bool withDistance,
                               GeometrySamples& samples) {
    const Stopwatch watch(renderSeconds_);
    makeRoom(sheet, withDistance, samples);
    std::vector<TileRays> tiles;
    for (std::size_t w = 0; w < sheet.scenes.size(); ++w)
        tiles.emplace_back(sheet.scenes[w], sheet.sheet.tiles[w]);
    const std::vector<TileRows> pieces = rowsOf(sheet.sheet);
    std::vector<std::vector<float>> lists(pieces.size()); // of fragments
    parallelFor(pieces.size(), [&](std::size_t i) {
        for (int row = pieces[i].first; row < pieces[i].last; ++row)
            tiles[pieces[i].tile].traceRow(row, samples, lists[i]);
    });
    gather(lists, samples);
}

void RayEngine::traceRuns(const SheetScene& sheet, std::size_t tile,
                          const std::vector<SampleRun>& runs, GeometrySamples& samples) {
    makeRoom(sheet, true, samples);
    const TileRays rays(sheet.scenes[tile], sheet.sheet.tiles[tile]);
    std::vector<std::vector<float>> lists(runs.size()); // of fragments
    parallelFor(runs.size(), [&](std::size_t i) {
        const SampleRun& run = runs[i];
        rays.traceRow(run.row, run.firstColumn, run.firstColumn + run.count, samples, lists[i]);
    });
    gather(lists, samples);
}

void RayEngine::renderRadiance(const SheetScene& sheet, RadianceSamples& samples) {
    if (std::ranges::any_of(sheet.scenes, &SurfaceScene::hasTransparent))
        throw LogicError("radiance alone was drawn of what lies behind a transparent surface");
    sampleGeometry(sheet, false, factors_);
    samples.width = factors_.width;
    samples.height = factors_.height;
    samples.layersLeftOver = 0;
    samples.planes.assign(2 * factors_.size(), 0.0f);
    const std::vector<SurfaceRow>& rows = sheet.scenes.front().rows;
    for (std::size_t i = 0; i < factors_.size(); ++i)
        factors_.forEachLayer(i, [&](const GeometrySamples::Layer& layer) {
            const SurfaceRow& row = rows[static_cast<std::size_t>(layer.row)];
            float apparent = row.constant;
            for (std::size_t f = 0; f < layer.factors.size(); ++f)
                apparent += layer.factors[f] * row.radiance[f];
            samples.planes[2 * i] = apparent;
            samples.planes[2 * i + 1] = row.opacity;
        });
}

} // namespace irsg
