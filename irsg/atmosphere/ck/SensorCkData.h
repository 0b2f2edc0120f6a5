#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/engine/RadiativeTransfer.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/SpectralSampling.h"

namespace irsg {

/// What wideband quadrature points are prepared for.
struct CkRequest {
    Band band = Band::topHat(3.0, 5.0);
    SunPosition sun;
    /// Paths that the scene will use, where they are known; a spread of paths is always added.
    std::vector<AtmosphericPath> paths;
    /// Emissivities and transmissivities of the scene's surfaces. Not owned, as those that follow;
    /// need to live during the preparation only.
    std::vector<const Spectrum*> materials;
    /// User-defined radiances of the scene's gases, W m-2 sr-1 um-1: each is trained as it is, so
    /// that lines of a hot gas that sit on the air's lines keep their correlation.
    std::vector<const Spectrum*> radiances;
    double largestError = 0.003; ///< of in-band quantities on the training cases, relative
    std::size_t mostPoints = 250;
};
class Atmosphere;
class CacheKey;
class CkNodes;
struct CkAtmosphere;
struct SparseWeights;
/// Adds all of a request to what its points are found by, and what training itself is.
void addTo(CacheKey& key, const CkRequest& request);
/// Adds nodes and values; a constant has a value and no wavelength.
void addTo(CacheKey& key, const Spectrum& spectrum);

/// Wideband correlated-k (F17): a few monochromatic quadrature points that stand for a sensor's
/// whole band.
///
/// For every quantity f of a scene, integral f R dlambda = sum over points of weight * f(point).
/// Points are spectral nodes of the atmosphere; they and their weights are chosen by non-negative
/// least squares so that in-band radiances of surfaces of 200 to 2200 K, grey and with structure,
/// through paths of all kinds, path and sky radiances, sun and fluxes equal those of the spectral
/// mode (optimal spectral sampling for a whole band, Moncet et al. 2008). A point is a wavelength;
/// emissivity, reflectivity, transmissivity and user-defined radiances are converted to their means
/// over its bin, `sampled`, black bodies to their value there, `planck`.
class SensorCkData : public SpectralSampling {
  public:
    /// Trains the points. Throws InputError where the band has no node in the atmosphere's table.
    static SensorCkData prepare(const RadiativeTransfer& transfer, const CkRequest& request);
    /// Of air that is not computed: `known` is `air` at its nodes, and the error on paths that were
    /// not trained is that against the spectral mode of `air`, which is asked at the points for it.
    static SensorCkData prepare(const CkAtmosphere& known, const Atmosphere& air,
                                const CkRequest& request);

    /// The points as text, and from it: nothing where it is damaged or of other tables. The band is
    /// that of the training.
    std::string cacheText() const;
    static std::optional<SensorCkData> fromCached(const CkNodes& nodes, const Band& band,
                                                  const std::string& text);

    /// A sampling as points; null where it is of another kind.
    static const SensorCkData* of(const SpectralSampling& sampling) {
        return dynamic_cast<const SensorCkData*>(&sampling);
    }

    const Band& band() const { return band_; }
    const NodeSet& nodes() const { return nodes_; }
    /// On the training cases, relative to each in-band quantity.
    double largestError() const { return largestError_; }
    double rmsError() const { return rmsError_; }
    /// On paths between the training's, which it never saw: what a user may expect.
    double heldOutError() const { return heldOutError_; }
    double heldOutRms() const { return heldOutRms_; }

    /// A spectrum's mean over the bin of every point.
    std::vector<double> sampled(const Spectrum& spectrum) const override;

  private:
    explicit SensorCkData(Band band) : band_(std::move(band)) {}
    SensorCkData(const CkNodes& nodes, const CkRequest& request, const SparseWeights& chosen);

    Band band_;
    NodeSet nodes_;
    std::vector<Spectrum> hats_; ///< over the bin of every point
    double largestError_ = 0.0, rmsError_ = 0.0, heldOutError_ = 0.0, heldOutRms_ = 0.0;
};

} // namespace irsg
