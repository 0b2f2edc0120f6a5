#include "irsg/scene/FrameSampler.h"

#include <algorithm>
#include <utility>

#include "irsg/core/StageReport.h"
#include "irsg/radiance/Reductions.h"
#include "irsg/radiance/SampleRadiances.h"
#include "irsg/radiance/TruthLayers.h"
#include "irsg/render/sampling/SampleSheet.h"
#include "irsg/scene/IndexNames.h"

namespace irsg {

namespace {

std::vector<const FrameBackground*> pointersTo(const std::vector<FrameBackground>& backgrounds) {
    std::vector<const FrameBackground*> pointers;
    for (const FrameBackground& background : backgrounds)
        pointers.push_back(&background);
    return pointers;
}

/// What was sampled in one go, for people to see.
std::vector<SampledTile> sampledTiles(const Frame& frame, const std::vector<RenderedTile>& drawn) {
    std::vector<SampledTile> result;
    const auto tell = [&](const RenderedTile& tile) {
        const ImageRectangle& r = tile.rectangle;
        SampledTile& told = result.emplace_back(
            SampledTile{r.left, r.top, r.right, r.bottom, tile.across, tile.down, {}});
        for (const int entity : tile.entities)
            told.objects += (told.objects.empty() ? "" : ", ") + frame.request.entity(entity).name;
    };
    for (const RenderedTile& tile : drawn)
        tell(tile);
    for (const ObjectExtent& point : frame.plan.points)
        tell({point.extent, 0.0, 0.0, {point.entity}});
    return result;
}

/// Draws tiles as radiances: as the shader adds them up, where one scale for each factor is
/// all there is to know of a surface, else from factors.
class SurfaceRttPass : public RttPass {
  public:
    /// `take`: what else is to get the factors of each tile; may be empty.
    SurfaceRttPass(const Frame& frame, const SurfaceSampler& surfaces,
                   OccluderStacks& occluderStacks, GeometrySamples& room, SurfaceSampler::Take take,
                   StageCount& drawings)
        : frame_(frame),
          surfaces_(surfaces),
          room_(room),
          take_(std::move(take)),
          drawings_(drawings),
          radiances_(frame.rows(), occluderStacks, frame.evaluation().evaluated->radiances,
                     frame.light()) {}
    int largestSide() const override { return frame_.surfaces.engine.engine.largestSide(); }
    void draw(const CameraFrame& camera, const SampleSheet& sheet,
              RadianceSamples& samples) override {
        Stopwatch watch(seconds);
        drawOne(camera, sheet, samples);
        drawings_.add();
    }
    double seconds = 0.0, sortSeconds = 0.0, evaluateSeconds = 0.0, takeSeconds = 0.0;
    int layersLeftOver = 0;
    bool isAllTaken = true; ///< the factors of all tiles that were drawn

  private:
    void drawOne(const CameraFrame& camera, const SampleSheet& sheet, RadianceSamples& samples) {
        const SheetScene scene = surfaces_.scenesOf(frame_.surfaces, camera, sheet);
        const auto isSlicedIn = [&](const SampleTile& tile) {
            return std::ranges::any_of(tile.entities, [&](int e) {
                return frame_.evaluation().geometry[static_cast<std::size_t>(e)].slices_m.size() >
                       1;
            });
        };
        const bool isSliced = std::ranges::any_of(sheet.tiles, isSlicedIn);
        if (!isSliced && !frame_.shading().isNeeded() &&
            std::ranges::none_of(scene.scenes, &SurfaceScene::hasTransparent)) {
            isAllTaken = false;
            return frame_.surfaces.engine.engine.renderRadiance(scene, samples);
        }
        GeometrySamples& factors = room_;
        const bool withDistance = isSliced || frame_.rows().hasGas() ||
                                  frame_.shading().isNeeded() ||
                                  (take_ && frame_.rows().needsDistances());
        frame_.surfaces.engine.engine.sampleGeometry(scene, withDistance, factors);
        {
            Stopwatch sorting(sortSeconds);
            frame_.shading().sortAndApply(scene, frame_.settings(), factors);
        }
        {
            Stopwatch evaluating(evaluateSeconds);
            radiances_.evaluate(factors, samples);
            giveToGroups(sheet, factors, samples);
        }
        if (take_) {
            Stopwatch taking(takeSeconds);
            for (const SampleTile& tile : sheet.tiles)
                take_(tile, factors);
        }
        if (factors.size() > mostSamplesCached)
            factors = {};
        layersLeftOver += samples.layersLeftOver;
    }

    const Frame& frame_;
    const SurfaceSampler& surfaces_;
    GeometrySamples& room_;
    SurfaceSampler::Take take_;
    StageCount& drawings_;
    SampleRadiances radiances_;
};

} // namespace

ViewSampling::ViewSampling(ViewKey key, const Frame& frame, std::size_t factorCount)
    : key_(std::move(key)),
      varying_(frame.backgrounds.varying()),
      sums_(frame.sensor(), key_.rows, occluderStacks_, factorCount, pointersTo(varying_),
            frame.exchange(), frame.request.withErrors),
      factors_(sums_.emptyView()) {}

bool ViewSampling::isOf(const ViewKey& key, const std::vector<FrameBackground>& varying) const {
    return key_ == key &&
           std::ranges::equal(
               varying, varying_,
               [](const FrameBackground& a, const FrameBackground& b) { return a.variesLike(b); });
}

FrameSampler::FrameSampler(const RadianceTerms& terms, SurfaceSampler& surfaces,
                           AspectSampler& aspects, OccluderStacks& occluderStacks,
                           StageClock& clock)
    : terms_(terms),
      surfaces_(surfaces),
      aspects_(aspects),
      occluderStacks_(occluderStacks),
      clock_(clock) {}

FrameSampler::~FrameSampler() = default;

std::vector<SampleTile> FrameSampler::tilesOf(const Frame& frame,
                                              const std::vector<ObjectExtent>& objects) {
    if (objects.empty())
        return {};
    return antialiasing_.strategyFor(frame.settings()).tiles(objects);
}

std::vector<SampleSheet> FrameSampler::sheetsOfPicture(const Frame& frame) {
    if (frame.plan.drawn.empty())
        return {};
    const int side = frame.surfaces.engine.engine.largestSide();
    return sheetsOf(piecesOf(tilesOf(frame, frame.plan.drawn), side), side);
}

std::shared_ptr<ViewSampling> FrameSampler::newSampling(const Frame& frame) {
    ViewKey key = viewKey(terms_, frame.request, frame.surfaces, frame.plan.alongRange);
    if (view_ && view_->isOf(key, frame.backgrounds.varying()))
        return nullptr;
    view_.reset();
    return std::make_shared<ViewSampling>(std::move(key), frame, terms_.factorCount());
}

std::shared_ptr<ViewSampling> FrameSampler::begin(const Frame& frame) {
    std::shared_ptr<ViewSampling> sampling = newSampling(frame);
    if (!sampling)
        return view_;
    // It outlives what is begun here: it waits for that when it goes.
    sampling->tiles_ =
        surfaces_.begin(frame.surfaces, frame.request.camera, tilesOf(frame, frame.plan.drawn),
                        frame.rows().needsDistances(), sampling->take());
    return view_ = sampling;
}

const ViewGeometry& FrameSampler::factorsOf(const Frame& frame, ViewSampling& sampling) {
    if (sampling.failure_)
        std::rethrow_exception(sampling.failure_);
    if (sampling.isFinished_)
        return sampling.factors_;
    try {
        if (sampling.tiles_.valid())
            surfaces_.waitFor(sampling.tiles_, "factor sums");
        ViewGeometry own = std::exchange(sampling.factors_, sampling.sums_.emptyView());
        sampling.factors_.layersLeftOver = own.layersLeftOver;
        const auto take = [&](ViewGeometry& from, ViewGeometry& to) {
            for (auto& [kind, sums] : from.light)
                to.light[{occluderStacks_.numberOf(sampling.occluderStacks_.materials(kind.first)),
                          kind.second}] = std::move(sums);
            to.field.add(
                from.field, [](std::size_t) { return std::size_t{0}; },
                [&](int stack) {
                    return occluderStacks_.numberOf(sampling.occluderStacks_.materials(stack));
                });
        };
        take(own, sampling.factors_);
        for (std::size_t k = 0; k < own.sublatticeDifferences.size(); ++k)
            take(own.sublatticeDifferences[k], sampling.factors_.sublatticeDifferences[k]);
        for (const ObjectExtent& object : frame.plan.points)
            addPointToView(aspects_.pointGeometry(frame, object), frame.rows(),
                           AspectSampler::placeOf(frame, object), pointersTo(sampling.varying_),
                           sampling.factors_);
        for (const AlongRange& one : frame.plan.alongRange)
            aspects_.addAlongRange(frame, one, pointersTo(sampling.varying_), sampling.factors_);
        sampling.isFinished_ = true;
    } catch (...) {
        sampling.failure_ = std::current_exception();
        view_.reset(); // the next one tries again
        throw;
    }
    return sampling.factors_;
}

SampledPicture FrameSampler::picture(const Frame& frame, bool withSums) {
    TileSamplingStrategy& strategy = antialiasing_.strategyFor(frame.settings());
    std::optional<FrameReduction> reduction;
    std::vector<std::string> warnings;
    int layersLeftOver = 0;
    if (frame.plan.drawn.empty()) {
        reduction.emplace(frame.sensor(), std::vector<SampleTile>{});
    } else {
        double all_s = 0.0, drawing_s = 0.0, sorting_s = 0.0, evaluating_s = 0.0, taking_s = 0.0;
        // The published antialiasing draws other tiles than sums are made of.
        std::shared_ptr<ViewSampling> sums =
            withSums && !frame.settings().usesPublishedTiles() ? newSampling(frame) : nullptr;
        const StageScope stage("drawing");
        StageCount drawings("tiles", StageListener::isThere() ? sheetsOfPicture(frame).size() : 0);
        surfaces_.onEngine(frame.surfaces.engine, [&] {
            Stopwatch watch(all_s);
            SurfaceRttPass rtt(frame, surfaces_, occluderStacks_, pictureFactors_,
                               sums ? sums->take() : SurfaceSampler::Take(), drawings);
            reduction = strategy.draw(frame.request.camera, frame.plan.drawn, rtt);
            drawing_s = rtt.seconds;
            sorting_s = rtt.sortSeconds;
            evaluating_s = rtt.evaluateSeconds;
            taking_s = rtt.takeSeconds;
            if (sums && rtt.isAllTaken)
                view_ = std::move(sums);
            layersLeftOver = rtt.layersLeftOver;
        });
        clock_.add("layer sorting", sorting_s);
        clock_.add("evaluation", evaluating_s);
        if (taking_s > 0.0)
            clock_.add("factor sums", taking_s);
        clock_.add("reduction", all_s - drawing_s);
        warnings = strategy.takeMessages();
    }
    for (const ObjectExtent& object : frame.plan.points)
        addPointToPixel(aspects_.pointGeometry(frame, object), frame.rows(),
                        AspectSampler::placeOf(frame, object),
                        frame.evaluation().evaluated->radiances, frame.light(), *reduction);
    return {std::move(*reduction), sampledTiles(frame, strategy.takeTiles()), std::move(warnings),
            layersLeftOver};
}

SampledPicture FrameSampler::followedPicture(const Frame& frame, bool withSums) {
    // Points are not drawn here, and the published antialiasing resamples what it draws.
    const bool isSum = frame.plan.points.empty() && !frame.settings().usesPublishedTiles();
    std::optional<ViewKey> key;
    if (isSum)
        key = viewKey(terms_, frame.request, frame.surfaces, frame.plan.alongRange);
    if (!isSum || key != followed_.key) {
        followed_.key = std::move(key);
        followed_.factors.reset();
        return picture(frame, withSums);
    }

    const std::vector<SampleTile> planned =
        antialiasing_.strategyFor(frame.settings()).tiles(frame.plan.drawn);
    if (!followed_.factors)
        followed_.factors = pixelFactors(frame);
    FrameReduction reduction(frame.sensor(),
                             piecesOf(planned, frame.surfaces.engine.engine.largestSide()));
    clock_.timed("sums of pixels", [&] {
        addPixels(*followed_.factors, frame.sensor().width_px,
                  frame.evaluation().evaluated->radiances, frame.light(), reduction);
    });
    return {std::move(reduction), sampledTiles(frame, RenderedTile::of(planned)), {}, 0};
}

PixelGeometry FrameSampler::pixelFactors(const Frame& frame) {
    GeometrySums sums(frame.sensor(), frame.rows(), occluderStacks_, terms_.factorCount(), {},
                      frame.exchange());
    PixelGeometry factors = sums.emptyPixels();
    surfaces_.sample(frame.surfaces, frame.request.camera, tilesOf(frame, frame.plan.drawn),
                     frame.rows().needsDistances(), "factors of pixels",
                     [&](const SampleTile& tile, const GeometrySamples& samples) {
                         sums.addToPixels(tile, samples, factors);
                     });
    return factors;
}

void FrameSampler::addTruthLayers(const Frame& frame, const FrameBackground& background,
                                  RadianceImage& image) {
    EvaluatedScene& evaluated = *frame.evaluation().evaluated;
    TruthLayers truth(frame.sensor(), evaluated.radiometry, evaluated.radiances, occluderStacks_,
                      background, frame.light(), image);
    surfaces_.sample(
        frame.surfaces, frame.request.camera, tilesOf(frame, frame.plan.seen), true, "truth layers",
        [&](const SampleTile& tile, const GeometrySamples& samples) { truth.add(tile, samples); });
    nameIndices(frame.scene().entities, image);
}

} // namespace irsg
