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
    bool hasGas = false;
    std::vector<std::string> warnings;

    /// Whether it must know where surfaces are.
    bool isNeeded() const { return shadows || lobes; }
    /// Lets samples stand for each other, takes away light of the sun, adds lobes, and says what
    /// samples count in gas.
    void apply(const SheetScene& sheet, const RenderSettings& settings,
               GeometrySamples& samples) const;
    /// Sorts the layers of a drawing, and does that.
    void sortAndApply(const SheetScene& sheet, const RenderSettings& settings,
                      GeometrySamples& samples) const;
};

} // namespace irsg
