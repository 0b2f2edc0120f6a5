#pragma once

#include <string>
#include <vector>

#include "irsg/image/RadianceImage.h"
#include "irsg/scene/AspectSampler.h"
#include "irsg/scene/Frame.h"
#include "irsg/scene/FrameSampler.h"
#include "irsg/scene/HazeGains.h"
#include "irsg/scene/PreparedEntities.h"
#include "irsg/scene/SceneEvaluator.h"
#include "irsg/scene/StageClock.h"
#include "irsg/scene/scattering/SceneScattering.h"

namespace irsg {

/// Adds the haze of droplets around objects to a composed picture. Keeps databases and filters.
class HazeRenderer {
  public:
    /// All must live as long.
    HazeRenderer(PreparedEntities& prepared, SceneEvaluator& evaluator, FrameSampler& sampler,
                 AspectSampler& aspects, StageClock& clock)
        : prepared_(prepared),
          evaluator_(evaluator),
          sampler_(sampler),
          aspects_(aspects),
          clock_(clock) {}

    /// Throws InputError where the environment names a file that is no MTF database.
    void check(const Environment& environment);
    /// Warnings are added, each once. What that makes of the sums over the frame, by entity, where
    /// it is asked for.
    HazeGains add(const Frame& frame, const FrameBackground& background, bool withGains,
                  RadianceImage& image, std::vector<std::string>& warnings);

    /// The same without the picture, of the frame of one.
    HazeGains gains(const Frame& frame);

  private:
    /// The objects of a scene with the optical depths of their paths, still without pixels.
    std::vector<ScatteredObject> objectsOf(const Frame& frame, std::vector<std::string>& warnings);
    void addPixels(const Frame& frame, const PixelGeometry& factors,
                   std::vector<ScatteredObject>& objects);
    void addPoints(const Frame& frame, std::vector<ScatteredObject>& objects);
    /// Tells of objects that are partly or wholly outside the frame, and near enough for their
    /// haze.
    void warnOfOutside(const Frame& frame, int support_px, std::vector<std::string>& warnings);

    PreparedEntities& prepared_;
    SceneEvaluator& evaluator_;
    FrameSampler& sampler_;
    AspectSampler& aspects_;
    StageClock& clock_;
    SceneScattering scattering_;
};

} // namespace irsg
