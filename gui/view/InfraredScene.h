#pragma once

#include <map>
#include <memory>
#include <string>

#include "gui/view/InfraredRequest.h"
#include "smatcore/analysis/PlacedCase.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::gui {

/// The renderer behind the infrared display, for one thread. Keeps models, databases, atmospheres
/// and all drawing memory between pictures: a changed camera, pose, state or database costs the
/// radiometry and a drawing, and nothing is loaded again.
class InfraredScene {
  public:
    InfraredScene();

    /// Throws irsg::InputError with every diagnostic of the scene. LogicError for a request without
    /// project or colour map.
    InfraredPicture draw(const InfraredRequest& request);
    /// Models read from their files so far.
    long modelsLoaded() const { return modelsLoaded_; }

  private:
    PlacedCase placed(const InfraredRequest& request);
    const irsg::Environment& environment(const InfraredRequest& request);

    RenderDoor door_ = openRenderDoor();
    LoadedModels offered_, loaded_; ///< by the window; those of them not yet taken
    /// Beside each model that was offered so far.
    std::map<ModelKey, std::shared_ptr<const irsg::ModelCodes>> codes_;
    long modelsLoaded_ = 0;
    SceneBuilder builder_;
    std::string environmentKey_;
    irsg::Environment environment_;

    // The last picture's radiance and what it is seen by.
    std::shared_ptr<irsg::RadianceImage> image_;
    irsg::SensorView view_;
    InfraredPicture last_;
};

/// The colours of a plane, one pixel each; values out of the limits in colours of their own, or in
/// those of the ends.
QImage colorsOf(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                const irsg::ColorMap& map, const irsg::DisplayLimits& limits);

} // namespace smat::gui
