#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "irsg/radiance/ScaledView.h"
#include "smatcore/data/Provenance.h"
#include "smatcore/data/SceneDescription.h"
#include "smatcore/project/Project.h"

namespace smat {

/// A scale of a scene: what it multiplies, how it is distributed, and what people call it.
struct SceneScaling {
    irsg::ScalingInput input;
    irsg::Distribution distribution;
    std::string name; ///< "temperature 5 (exhaust pipes)", with the entity where there are several

    bool isFixed() const { return distribution.isFixed(); }
    /// Its value in draw number `draw` of a seed, from a random sequence of its own.
    double at(std::uint64_t seed, std::uint64_t draw) const;
};

/// The scales of an entity of one kind, by index.
std::map<int, double>& scalesOf(irsg::Entity& entity, irsg::ScalingKind kind);

/// The scales that the files beside the models of a project give to a scene, entity by entity,
/// temperatures first. Scales of 1 are left out; so are, with a remark, temperature scales of
/// user-defined spectra, and indices that no entry or no face of the model has. Throws InputError
/// for files that cannot be read, and where no model has a scaling file.
std::vector<SceneScaling> sceneScalings(const Project& project, const SceneDescription& scene,
                                        std::vector<std::string>& remarks);

/// "log-normal, 0.95 to 1.08", with the parameters that are not those of the range; "1.02" of a
/// fixed one.
std::string describe(const irsg::Distribution& distribution);

/// Scales the entities of a scene with draw 0 of a seed, and notes what was drawn: what loading its
/// databases does where the settings ask for scalings.
void applyScalings(const Project& project, std::uint64_t seed, SceneDescription& scene);

/// What a result says of scales: `scaling.seed`, where it is the default, and a `drawn scale` each.
/// Nothing where none were drawn.
void tellSampledScales(const SceneDescription& scene, const Settings& settings,
                       Provenance& provenance);

} // namespace smat
