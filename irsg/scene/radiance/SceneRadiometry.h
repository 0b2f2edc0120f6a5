#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/SpectralSampling.h"
#include "irsg/scene/radiance/ApparentRadiance.h"
#include "irsg/scene/radiance/SceneAir.h"

namespace irsg {

class WidebandTerms;

/// A scene's spectra, on wavelengths of the caller's choice, on the quadrature of a band or on
/// wideband terms, which are a quadrature, too.
class SceneRadiometry {
  public:
    /// For in-band quantities: nodes and weights are those of the sensor's band.
    SceneRadiometry(const Environment& environment, const std::vector<Entity>& entities,
                    const std::vector<ObjectGeometry>& geometry, const RenderSettings& settings,
                    const LineOfSight& centre, const Band& band);
    /// For in-band quantities in the wideband mode: a node is a term, and spectra are means over
    /// its bin.
    SceneRadiometry(const Environment& environment, const std::vector<Entity>& entities,
                    const std::vector<ObjectGeometry>& geometry, const RenderSettings& settings,
                    const LineOfSight& centre, const WidebandTerms& terms);
    /// For spectra at given wavelengths, ascending; weights are 1.
    SceneRadiometry(const Environment& environment, const std::vector<Entity>& entities,
                    const std::vector<ObjectGeometry>& geometry, const RenderSettings& settings,
                    const LineOfSight& centre, std::vector<double> wavelengths_um);

    /// Surfaces by (entity, codes), in that order; the rows of a drawing.
    using SurfaceKey = std::pair<int, IrCodes>;
    const std::vector<SurfaceKey>& keys() const { return keys_; }
    const std::vector<SurfaceSpectra>& surfaces() const { return surfaces_; }
    int row(int entity, const IrCodes& codes) const;

    const SpectralSampling& sampling() const { return *sampling_; }
    const std::vector<double>& wavelengths_um() const { return sampling_->wavelengths_um(); }
    const std::vector<double>& weights_um() const { return sampling_->weights_um(); }
    const std::vector<double>& background() const { return background_; }
    /// The air between an entity and the sensor.
    const AirSamples& air(int entity) const { return air_.at(static_cast<std::size_t>(entity)); }
    /// Spectral transmissivity of a material of an entity.
    const std::vector<double>& transmissivity(int entity, int material) const;

    /// Sum of weight times value.
    double integrate(const std::vector<double>& values) const {
        return sampling_->integrate(values);
    }
    double integrate(const std::vector<double>& a, const std::vector<double>& b) const {
        return sampling_->integrate(a, b);
    }
    double backgroundInBand_W_m2_sr() const { return integrate(background_); }
    /// Transmissivity of a row as one number, weighted with the background's radiance, or with the
    /// response alone where there is none.
    double scalarTransmissivity(int row) const;
    double scalarTransmissivityOf(int entity, int material) const;
    /// Largest relative error that the scalar makes for any surface seen through any other.
    double transmissivityResidue() const;

    const std::vector<std::string>& answeredBy() const { return answeredBy_; }
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    void fill(const std::vector<Entity>& entities, const std::vector<ObjectGeometry>& geometry,
              const RenderSettings& settings, SceneAir air, const SpectrumSampler& sample,
              double bandArea_um);

    void fillScalarTransmissivities();

    std::shared_ptr<const SpectralSampling> sampling_;
    std::vector<double> background_;
    std::vector<SurfaceKey> keys_;
    std::vector<SurfaceSpectra> surfaces_;
    std::vector<AirSamples> air_; // by entity
    std::map<std::pair<int, int>, std::vector<double>> transmissivities_;
    std::map<std::pair<int, int>, double> scalarTransmissivities_;
    std::vector<std::string> answeredBy_, warnings_;
};

} // namespace irsg
