#pragma once

#include <functional>
#include <mutex>

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/PixelText.h"
#include "smatcore/data/RenderDoor.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat {

/// Says what the pixels of an image are made of (docs/explain.md): draws it, once, as
/// `smat-batch image` does, and follows rays through the samples of each pixel that is asked for.
/// May be used from any thread, one question after another.
class PixelExplainer {
  public:
    /// `image` is an analysis of the form image with what it is asked; what came out of it is not
    /// used, but for the databases as they were. `models` and `door` stand in for the usual ones
    /// where they are given. Throws InputError for several bands, where this build has no rays, and
    /// as AnalysisGenerator::run does.
    explicit PixelExplainer(AnalysisData image, SceneBuilder::ModelLoader models = {},
                            RenderDoor door = {}, StageTimer* timer = nullptr);
    ~PixelExplainer();
    PixelExplainer(const PixelExplainer&) = delete;
    PixelExplainer& operator=(const PixelExplainer&) = delete;

    /// The image that it drew, as radiance, with warnings and renderer.
    const AnalysisData& drawn() const { return data_; }
    /// LogicError for a pixel outside the image; 0, 0 is the top left one.
    ExplainedPixel explain(int x, int y);

  private:
    AnalysisData data_;
    std::mutex mutex_;
    RenderDoor door_;
    std::function<irsg::PixelExplanation(int x, int y)> explain_; ///< of the door
};

} // namespace smat
