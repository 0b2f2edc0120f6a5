#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "irsg/atmosphere/engine/RadiativeTransfer.h"
#include "irsg/radiometry/AxisToNodes.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/SpectralSampling.h"

namespace irsg {

/// The spectral mode of computed air at its nodes: several a bin, each a single wavenumber with its
/// share of the bin (see GasTable). Light that meets the same lines twice, on its way to a surface
/// and from there to the sensor, is multiplied at a node, where a product of two means of a bin
/// would lose what they have in common.
///
/// A spectrum of that mode is linear between the means at the centres of bins, so a bin's share of
/// a band is the integral of the hat function over its centre and its neighbours' centres, times
/// the response. All nodes of a bin have one wavelength, the middle of that share, where black
/// bodies are taken; other spectra are means over it. Sums of a single quantity so are those of the
/// spectrum of the air.
class AtmosphereNodes : public SpectralSampling {
  public:
    /// Of bands, ascending and at most touching each other. LogicError where the table of gases has
    /// no bin in one.
    AtmosphereNodes(std::shared_ptr<const RadiativeTransfer> transfer,
                    const std::vector<Band>& bands);
    /// At ascending wavelengths, each by the nodes of the bins on either side of it.
    AtmosphereNodes(std::shared_ptr<const RadiativeTransfer> transfer,
                    const std::vector<double>& wavelengths_um);

    /// The same object as what it is; null for another sampling.
    static const AtmosphereNodes* of(const SpectralSampling& sampling);
    bool isOf(const std::shared_ptr<const RadiativeTransfer>& transfer) const {
        return transfer_ == transfer;
    }

    /// All nodes, each once.
    const NodeSet& set() const { return set_; }
    /// Values of the set in the order of the sampling.
    std::vector<double> arranged(std::span<const double> ofSet) const;
    std::vector<double> sampled(const Spectrum& spectrum) const override;
    /// The same for many spectra of one axis that hold their ends.
    AxisToNodes fromAxis(const std::vector<double>& wavelengths_um) const;
    /// Nodes that are summed together: those of each band, or of each wavelength.
    const std::vector<std::pair<std::size_t, std::size_t>>& outputs() const { return outputs_; }

  private:
    /// Nodes that share a wavelength: those of a bin, or of the two bins around a wavelength.
    struct Group {
        double wavelength_um = 0.0;
        Spectrum hat = {};                ///< over the centre of the bin
        std::size_t band = 0;             ///< of `bands_`
        double area_um = 0.0;             ///< of hat times response; 0 at a wavelength
        std::size_t first = 0, count = 0; ///< in the sampling
    };
    void addBand(std::size_t number);
    /// Integral of a hat times the response of a band times another function.
    static double integralOver(const Spectrum& hat, const Spectrum& other, const Band& band);
    void finish(const SpectralRange& range);
    void addNodes(const SpectralBin& bin, double weight, std::size_t firstOfSet);

    std::shared_ptr<const RadiativeTransfer> transfer_;
    NodeSet set_;
    std::vector<Band> bands_; ///< none at wavelengths
    std::vector<Group> groups_;
    std::vector<std::size_t> ofSet_; ///< of every node of the sampling, its place in the set
    std::vector<double> nodeWeights_;
    std::vector<std::pair<std::size_t, std::size_t>> outputs_;
};

} // namespace irsg
