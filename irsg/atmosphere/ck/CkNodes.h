#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "irsg/atmosphere/engine/RadiativeTransfer.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/GaussLegendre.h"

namespace irsg {

/// The nodes of an air's spectral mode over a band, and what each weighs in an integral with the
/// response: the candidates for quadrature points. A spectrum of that mode is linear between the
/// means at the centres of bins, so a bin's share of an integral is that of the hat function over
/// its centre and its neighbours' centres.
class CkNodes {
  public:
    /// Computed air: several nodes a bin.
    CkNodes(const RadiativeTransfer& transfer, const Band& band);
    /// Air that is known at ascending wavelengths, between which it is linear: a node each,
    /// numbered from `first` on. They surround the band.
    CkNodes(const std::vector<double>& wavelengths_um, std::size_t first, const Band& band);
    std::size_t size() const { return set.nodes.size(); }

    /// A function of wavelength in the two forms that training needs.
    struct Shares {
        /// Per node the integral over its bin's hat of R times the function, times the node's
        /// weight.
        std::vector<double> integrated;
        /// Per node the mean over its bin's hat, as SensorCkData::sampled gives it.
        std::vector<double> sampled;
    };
    /// Points of a bin that a function is integrated at, unless it is known to be smooth.
    static constexpr int pointsOfBin = 32;
    template <typename Function>
    Shares shares(Function f, int points = pointsOfBin) const {
        std::vector<double> withResponse(centres_um_.size()), alone(centres_um_.size());
        integrate(
            [&](double at_um) {
                return std::pair{f(at_um), band_.responseAt(at_um)};
            },
            withResponse, alone, points);
        Shares of{std::vector<double>(size()), std::vector<double>(size())};
        for (std::size_t i = 0; i < size(); ++i) {
            const std::size_t bin = binOf_[i];
            of.integrated[i] = weight_[i] * withResponse[bin];
            of.sampled[i] = widths_[bin] > 0.0 ? alone[bin] / widths_[bin] : 0.0;
        }
        return of;
    }
    /// The hat over a node's bin, cut to the band: linear to 0 at the neighbours' centres.
    Spectrum hat(std::size_t node) const;
    /// 0 for the first node of a bin.
    std::size_t placeInBin(std::size_t node) const {
        std::size_t first = node;
        while (first > 0 && binOf_[first - 1] == binOf_[node])
            --first;
        return node - first;
    }
    const std::vector<double>& ones() const { return ones_; }
    double wavelength_um(std::size_t i) const { return 1e4 / set.wavenumbers_per_cm[i]; }

    NodeSet set;

  private:
    /// Adds the integrals of f R and of f, which f gives with R, times every bin's hat over the
    /// band.
    template <typename Function>
    void integrate(Function f, std::vector<double>& withResponse, std::vector<double>& alone,
                   int points) const {
        const GaussRule& rule = gaussLegendre(points);
        for (std::size_t b = 0; b + 1 < centres_um_.size(); ++b) { // wavelengths fall
            const double lower_um = std::max(centres_um_[b + 1], band_.range().min_um);
            const double upper_um = std::min(centres_um_[b], band_.range().max_um);
            if (!(lower_um < upper_um))
                continue;
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                const double at_um = lower_um + (upper_um - lower_um) * rule.nodes[i];
                const auto [own, response] = f(at_um);
                const double value = own * (upper_um - lower_um) * rule.weights[i];
                const double part =
                    (at_um - centres_um_[b + 1]) / (centres_um_[b] - centres_um_[b + 1]);
                withResponse[b] += part * value * response;
                withResponse[b + 1] += (1.0 - part) * value * response;
                alone[b] += part * value;
                alone[b + 1] += (1.0 - part) * value;
            }
        }
    }
    /// What is the same for all functions; the last step of constructors.
    void prepare();

    Band band_;
    std::vector<std::size_t> binOf_; ///< of every node
    std::vector<double> centres_um_; ///< of every bin, falling
    std::vector<double> widths_;     ///< of the hats within the band
    std::vector<double> weight_, ones_;
};

} // namespace irsg
