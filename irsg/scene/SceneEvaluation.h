#pragma once

#include <memory>
#include <vector>

#include "irsg/geometry/view/FrameBackground.h"
#include "irsg/radiance/RadiometryCache.h"
#include "irsg/radiance/SampledScene.h"
#include "irsg/radiance/SceneAtmosphere.h"
#include "irsg/render/background/SceneBackground.h"
#include "irsg/render/sampling/SurfaceScene.h"
#include "irsg/scene/BackgroundBehind.h"

namespace irsg {

/// What the surfaces of a scene send, and the atmosphere before them, in the bands of a request.
struct SceneEvaluation {
    std::vector<ObjectGeometry> geometry; ///< by entity, with slices and lobe directions
    std::shared_ptr<const SampledScene> sampled;
    BackgroundBehind behind;
    /// Where the background is another one and errors were asked for: what is behind the objects.
    struct {
        std::vector<ObjectGeometry> geometry;
        BackgroundBehind behind;
    } compared;
    /// Shared with other frames, which turn it to their aspects: see turned().
    std::shared_ptr<EvaluatedScene> evaluated;
    std::vector<SurfaceRow> rows; ///< by drawn row, in the first band
    std::vector<bool> hot;        ///< by drawn row: worth samples of its own

    const SurfaceRows& surfaceRows() const { return evaluated->radiometry.rows(); }
    /// Behind the objects by node of the bands: that of the object which is looked at, or of the
    /// field's centre.
    const SharedValues& background() const {
        return behind.background ? behind.background : sampled->background;
    }
    /// By entity, sensor to reference point.
    std::vector<double> ranges_m() const;
    /// The evaluated scene as this frame sees it, whatever frame was made since.
    EvaluatedScene& turned(const std::vector<Entity>& entities) const;
};

/// What is behind the objects of a frame.
struct FrameBackgrounds {
    std::vector<FrameBackground> byOutput; ///< of a picture
    /// What sums over objects take: the same, or a uniform one, as each object has its own.
    std::vector<FrameBackground> ofSums;
    BackgroundReport report;
    BackgroundLayers layers; ///< of the last band

    // Of those that sums take:
    bool areUniform() const;
    /// Those that vary over the frame, in the order of the outputs.
    std::vector<FrameBackground> varying() const;
    /// By output the number of its background among those, or -1 for a uniform one.
    std::vector<int> numbersOfVarying() const;
};

} // namespace irsg
