#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QImage>
#include <QMetaType>
#include <QSize>

#include "gui/image/ColorRule.h"
#include "gui/workbench/ModelStore.h"
#include "gui/workbench/OrbitCamera.h"
#include "irsg/image/ColorMap.h"
#include "irsg/image/RadianceImage.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::gui {

/// What the infrared display shows of a pixel.
enum class InfraredQuantity { radiance, apparentTemperature };

/// One picture that the infrared display is asked for. The project's atmosphere, sun, band and
/// rendering settings apply; size and field of view are the view's own.
struct InfraredRequest {
    std::shared_ptr<const Project> project;
    Settings settings; ///< of the project, with what was changed in the window on top
    SceneBuilder::DatabaseOverrides edited;
    LoadedModels models;
    OrbitCamera camera;
    double targetYaw_rad = 0.0;
    QSize size_px{1, 1};
    double horizontalFieldOfView_rad = 0.035;
    /// One sample a pixel, for a picture that is gone in a moment; else the antialiasing of the
    /// settings.
    bool coarse = false;
    /// Without light between surfaces, the first look at a model for which it takes long; coarse.
    bool direct = false;
    /// Counts what changes the radiance; with an equal number only the colours are made anew.
    long revision = 0;

    InfraredQuantity quantity = InfraredQuantity::radiance;
    const irsg::ColorMap* map = nullptr;
    std::optional<irsg::DisplayLimits> limits; ///< between these, else those the rule finds
    ColorRule rule;
};

/// What came of it.
struct InfraredPicture {
    /// "L" in W m-2 sr-1, and "T_apparent" in K where it was asked for.
    std::shared_ptr<const irsg::RadianceImage> image;
    QImage colors; ///< of the same size, top row first
    InfraredQuantity quantity = InfraredQuantity::radiance;
    irsg::DisplayLimits limits;
    irsg::Viewpoint eye;
    QSize size_px; ///< of the picture
    double horizontalFieldOfView_rad = 0.035;
    bool coarse = false, direct = false;
    long revision = 0;
    double radiance_s = 0.0; ///< time that the radiance took; 0 where it was there already
    double seconds = 0.0;    ///< from the start of the work to its end

    /// The plane that is shown.
    const irsg::ImageChannel& plane() const;
};

} // namespace smat::gui

Q_DECLARE_METATYPE(smat::gui::InfraredPicture)
