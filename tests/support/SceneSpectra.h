#pragma once

#include <memory>
#include <string>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/radiance/SceneRadiometry.h"
#include "irsg/radiance/SceneSampling.h"

namespace irsg::test {

/// The geometry of an object of no extent at the end of a path.
inline ObjectGeometry geometryOf(const AtmosphericPath& path) {
    ObjectGeometry geometry;
    geometry.path = path;
    geometry.nearest_m = geometry.farthest_m = path.range_m;
    return geometry;
}

/// The spectra of a scene in a band, in the spectral mode.
inline SceneRadiometry inBand(const Environment& environment, const std::vector<Entity>& entities,
                              const std::vector<ObjectGeometry>& geometry,
                              const RenderSettings& settings, const LineOfSight& centre,
                              const Band& band) {
    AtmosphericQueryCache air;
    air.setEnvironment(environment);
    const RadianceTerms& terms = RadianceTerms::standard();
    SceneSampling sampling;
    return {terms, entities, geometry,
            sampling.spectral(air, {terms, entities, geometry, settings, centre}, {band})};
}

/// The same at quadrature points of wideband-ck.
inline SceneRadiometry atPoints(const Environment& environment, const std::vector<Entity>& entities,
                                const std::vector<ObjectGeometry>& geometry,
                                const RenderSettings& settings, const LineOfSight& centre,
                                const std::shared_ptr<const WidebandPoints>& wideband) {
    AtmosphericQueryCache air;
    air.setEnvironment(environment);
    const RadianceTerms& terms = RadianceTerms::standard();
    return {
        terms,
        entities,
        geometry,
        {SceneSampling::wideband(air, {terms, entities, geometry, settings, centre}, wideband)}};
}

/// A term of a row of a scene as it arrives, by its name.
inline std::vector<double> term(const SceneRadiometry& scene, int row, const std::string& name) {
    const auto& terms = RadianceTerms::standard().terms;
    for (std::size_t k = 0; k < terms.size(); ++k) {
        if (terms[k].name == name) {
            return apparentTerm(scene.surface(row), RadianceTerms::standard(), k, scene.air(row));
        }
    }
    throw LogicError("no term is called " + name);
}

} // namespace irsg::test
