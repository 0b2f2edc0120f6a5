#pragma once

#include <memory>
#include <string>
#include <vector>

#include "irsg/radiance/RadianceTerms.h"
#include "irsg/scene/FramePlan.h"
#include "irsg/scene/FrameRequest.h"
#include "irsg/scene/SceneSurfaces.h"

namespace irsg {

/// All that the factors of a view depend on.
struct ViewKey {
    std::vector<double> numbers;
    std::vector<std::shared_ptr<const Model>> models;
    std::shared_ptr<const Terrain> terrain;
    SurfaceRows rows;
    std::string shader;
    bool operator==(const ViewKey&) const = default;
};

/// `alongRange`: the objects whose factors are interpolated between distances.
ViewKey viewKey(const RadianceTerms& terms, const FrameRequest& request,
                const SceneSurfaces& surfaces, const std::vector<AlongRange>& alongRange);

/// Appends what the receivers of inter-reflection are numbered by.
void appendReceivers(const SurfaceShading& shading, double lightError,
                     std::vector<double>& numbers);
/// Appends what the factors of lobes depend on.
void appendLobes(const SceneSurfaces& surfaces, std::vector<double>& numbers);

} // namespace irsg
