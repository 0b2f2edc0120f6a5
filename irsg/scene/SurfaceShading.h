#pragma once

#include <memory>
#include <string>
#include <vector>

#include "irsg/radiance/LobeQuadrature.h"
#include "irsg/render/rays/SunShadows.h"
#include "irsg/render/sampling/JoinedSamples.h"
#include "irsg/render/values/RenderSettings.h"
#include "irsg/scene/InterReflected.h"

namespace irsg {

/// What is done to the factors of samples once their layers are sorted. Null is what a scene does
/// not have.
struct SurfaceShading {
    std::shared_ptr<const SunShadows> shadows; ///< with the places of samples for inter-reflection
    InterReflected between;
    std::shared_ptr<const LobeQuadrature> lobes; ///< of directional surfaces
    std::shared_ptr<const LobeAims> aims;        ///< of these
    JoinLimits joins;                            ///< of no row: all samples are alone
    std::vector<std::string> warnings;

    bool isNeeded() const { return shadows || lobes; }
    /// Lets samples stand for each other, takes away light of the sun, and adds lobes.
    void apply(const SheetScene& sheet, const RenderSettings& settings,
               GeometrySamples& samples) const;
    /// Sorts the layers of a drawing, and does that.
    void sortAndApply(const SheetScene& sheet, const RenderSettings& settings,
                      GeometrySamples& samples) const;
};

} // namespace irsg
