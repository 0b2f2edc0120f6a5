#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "irsg/scene/radiance/ApparentRadiance.h"
#include "irsg/scene/radiance/RadianceTerms.h"
#include "irsg/scene/radiance/SceneSampling.h"
#include "irsg/scene/radiance/SurfaceRows.h"

namespace irsg {

/// A scene's spectra on the nodes of its bands, one band behind the other: what every row of
/// SurfaceRows sends to the sensor, term by term.
class SceneRadiometry {
  public:
    /// `bands` hold the air of the entities in the same order, sliced as `geometry` says. Their
    /// databases must live as long.
    SceneRadiometry(const RadianceTerms& terms, const std::vector<Entity>& entities,
                    const std::vector<ObjectGeometry>& geometry,
                    const std::vector<SampledBand>& bands);

    /// The same but for the aspect angles in `geometry`: evaluates the rows anew whose measured
    /// spectra depend on them, and returns these. `bands` are those of before.
    std::vector<int> turn(const std::vector<Entity>& entities,
                          const std::vector<ObjectGeometry>& geometry,
                          const std::vector<SampledBand>& bands);

    const RadianceTerms& terms() const { return *terms_; }
    const SurfaceRows& rows() const { return rows_; }
    /// By row.
    const std::vector<SurfaceSpectra>& surfaces() const { return surfaces_; }

    const std::vector<double>& wavelengths_um() const { return wavelengths_um_; }
    const std::vector<double>& weights_um() const { return weights_um_; }
    /// Nodes that are summed together, first and behind the last: a band's, or one wavelength.
    const std::vector<std::pair<std::size_t, std::size_t>>& outputs() const { return outputs_; }
    /// The air between a row's place and the sensor.
    const AirSamples& air(int row) const;
    /// Spectral transmissivity of a material of an entity.
    const std::vector<double>& transmissivity(int entity, int material) const;

    /// Sum of weight times value over an output.
    double integrate(const std::vector<double>& values, std::size_t output = 0) const;
    /// In-band emission of a row as it arrives, W m-2 sr-1.
    double thermal_W_m2_sr(int row, std::size_t output = 0) const;

    const std::vector<std::string>& answeredBy() const { return answeredBy_; }
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    void fillRow(int row, const std::vector<Entity>& entities,
                 const std::vector<ObjectGeometry>& geometry,
                 const std::vector<SampledBand>& bands);
    /// A spectrum of the scene's databases at the nodes; sampled once.
    std::vector<double> sampled(const Spectrum& spectrum, const std::vector<SampledBand>& bands);

    const RadianceTerms* terms_;
    SurfaceRows rows_;
    std::vector<double> wavelengths_um_, weights_um_;
    std::vector<std::pair<std::size_t, std::size_t>> outputs_;
    std::vector<SurfaceSpectra> surfaces_;
    std::vector<std::vector<AirSamples>> air_; // by entity and node
    std::map<std::pair<int, int>, std::vector<double>> transmissivities_;
    std::vector<std::string> answeredBy_, warnings_;
    std::mutex sampling_;
    std::map<const Spectrum*, std::vector<double>> samples_;
};

/// True where the aspect angle enters what a temperature entry sends.
bool dependsOnAspect(const TemperatureEntry& entry);

/// Spectral radiance behind the objects at the field's centre on the nodes of the bands, one behind
/// the other, as the settings ask for it.
std::vector<double> backgroundOf(const std::vector<SampledBand>& bands,
                                 const RenderSettings& settings);

} // namespace irsg
