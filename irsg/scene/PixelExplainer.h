#pragma once

#include <vector>

#include "irsg/render/background/TerrainRays.h"
#include "irsg/render/values/PixelExplanation.h"
#include "irsg/scene/AspectSampler.h"
#include "irsg/scene/Frame.h"
#include "irsg/scene/FrameSampler.h"
#include "irsg/scene/PictureBackground.h"
#include "irsg/scene/SurfaceSampler.h"

namespace irsg {

/// Says what the pixels of a picture are made of, by rays through the samples that it takes of
/// them.
class PixelExplainer {
  public:
    /// A frame whose engine is rays. All must live as long; `occluderStacks` may grow.
    PixelExplainer(const Frame& frame, FrameSampler& sampler, SurfaceSampler& surfaces,
                   AspectSampler& aspects, TerrainRays& terrainRays, OccluderStacks& occluderStacks)
        : frame_(frame),
          surfaces_(surfaces),
          aspects_(aspects),
          terrainRays_(terrainRays),
          occluderStacks_(occluderStacks),
          sheets_(sampler.sheetsOfPicture(frame)),
          background_(backgroundOf(frame, sampler)) {}

    /// LogicError for a pixel outside the frame.
    PixelExplanation at(int x, int y);

  private:
    /// That of the picture: its pixels are asked only where it follows from them.
    static FrameBackground backgroundOf(const Frame& frame, FrameSampler& sampler) {
        return frame.backgrounds.byOutput.front().isUniform()
                   ? frame.backgrounds.byOutput.front()
                   : pictureBackground(frame, sampler.picture(frame, false).pixels);
    }

    const Frame& frame_;
    SurfaceSampler& surfaces_;
    AspectSampler& aspects_;
    TerrainRays& terrainRays_;
    OccluderStacks& occluderStacks_;
    std::vector<SampleSheet> sheets_;
    FrameBackground background_;
    GeometrySamples samples_; // room for those of a sheet
};

} // namespace irsg
