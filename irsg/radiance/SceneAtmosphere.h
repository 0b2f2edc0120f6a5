#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "irsg/geometry/Entity.h"
#include "irsg/radiance/ApparentRadiance.h"
#include "irsg/radiance/AtmosphericQueryCache.h"
#include "irsg/radiance/GasColumnSpectra.h"
#include "irsg/radiance/RadianceTerms.h"
#include "irsg/radiance/SpecularEnvironmentGrid.h"
#include "irsg/radiance/SurfaceRows.h"
#include "irsg/render/values/RenderSettings.h"

namespace irsg {

/// A line of sight behind an object, and the part of the object that it stands for.
struct SightBehind {
    LineOfSight sight;
    double weight = 1.0; ///< those of an object add up to 1
};

/// What the earth hides of an object.
enum class HiddenPart { none, some, all };

/// The geometry that the air is asked for, once per object or once per slice of it.
struct ObjectGeometry {
    AtmosphericPath path; ///< sensor to reference point
    /// Of the reference point, to 1e-6 m: where the horizon hides all of the object, the path ends
    /// above it.
    double altitude_m = 0.0;
    double aspectAngle_rad = 0.0; ///< nose axis to the direction reference point -> sensor
    /// Distances from the sensor that a sphere about the reference point spans which holds the
    /// object, m.
    double nearest_m = 0.0, farthest_m = 0.0;
    /// Unbounded, along the apparent direction of that path.
    LineOfSight sight;
    /// That direction less the one in which the flat scene has the object.
    double raised_rad = 0.0;
    HiddenPart hidden = HiddenPart::none;
    /// Altitudes at `nearest_m`, at the reference point and at `farthest_m` below which the earth
    /// hides the object, where it hides some of it.
    std::array<double, 3> hiddenBelow_m{};
    /// Where the background is that of the object's own directions; empty for that of the centre.
    std::vector<SightBehind> behind;
    SliceNodes slices_m; ///< of less than two nodes: the air is that of the reference point
    /// Directions of the air's radiance that its lobes reflect; empty where it has none.
    SpecularEnvironmentGrid mirror;
    /// Bound of what the air's change over the extent leaves wrong, as a part of what arrives, and
    /// what it is likely to be.
    double atmosphereError = 0.0, likelyAtmosphereError = 0.0;
};

/// The same but for digits that differ by rounding alone, so that the path which many views share
/// is one: ranges and altitudes to 1e-8 m or 1e-12, angles to 1e-10 rad.
AtmosphericPath steadied(const AtmosphericPath& path);
LineOfSight steadied(const LineOfSight& sight);

/// The part of a path next to the target, which a spectrum that was measured from there holds
/// already. `range_m` above 0, at most that of the path.
AtmosphericPath nearTarget(const AtmosphericPath& path, double range_m);
/// The path that ends on the line to the reference point at another range.
AtmosphericPath atRange(const AtmosphericPath& path, double range_m);

/// The air of one object on the nodes of a sampling.
struct ObjectAtmosphere {
    std::vector<AtmosphereSamples> nodes; ///< by node of its slices, or one
    double ambient_K = 288.15;
    /// Transmittance to the reference distance of a user-defined spectrum, by its name.
    std::map<std::string, SharedValues> toReference;
    std::set<std::string> insideReference; ///< names of spectra measured from farther away
    /// Before its gases: none where it has none, or where the air does not tell what it holds.
    std::optional<AirBeforeGas> beforeGas;
    std::vector<SharedValues>
        specular; ///< radiance onto it, by place of its SpecularEnvironmentGrid
    bool operator==(const ObjectAtmosphere& other) const;
};

/// All that a scene asks of its environment: once per object, and once for the background.
struct SceneAtmosphere {
    std::vector<ObjectAtmosphere> objects;
    SharedValues background;             ///< null where the environment is not asked for it
    std::vector<std::string> providedBy; ///< "transmittance: vacuum", each once
    std::vector<std::string> warnings;   ///< each once
};

/// What the settings do not use is not asked for, nor a node of slices that is not in `taken` (by
/// entity and node; every one where an entity has none): its samples are null. Throws InputError
/// where no atmosphere answers.
SceneAtmosphere sceneAtmosphere(AtmosphericQueryCache& answers, const RadianceTerms& terms,
                                const std::vector<Entity>& entities,
                                const std::vector<ObjectGeometry>& geometry,
                                const RenderSettings& settings, const LineOfSight& centre,
                                const std::shared_ptr<const SpectralSampling>& sampling,
                                const std::vector<std::vector<bool>>& taken = {});

/// The spectra of the same answers on the nodes that the air has of itself, for their kinks: of
/// every object at its reference point, and of the background.
std::vector<const Spectrum*>
atmosphereSpectra(AtmosphericQueryCache& answers, const RadianceTerms& terms,
                  const std::vector<Entity>& entities, const std::vector<ObjectGeometry>& geometry,
                  const RenderSettings& settings, const LineOfSight& centre,
                  const SpectralRange& range);

/// The queries behind all that: equal ones have equal answers of the same environment, whatever
/// the band. Those at other ranges of the same paths are left out.
std::vector<AtmosphericQueryKey> atmosphereQueries(const Environment& environment,
                                                   const RadianceTerms& terms,
                                                   const std::vector<ObjectGeometry>& geometry,
                                                   const RenderSettings& settings,
                                                   const LineOfSight& centre);

/// Ambient temperature at an object's altitude, K, and who said so.
Provided<double> ambientOf(const AtmosphericQueryCache& answers, const ObjectGeometry& geometry);

} // namespace irsg
