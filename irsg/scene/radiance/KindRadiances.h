#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "irsg/scene/radiance/FactorField.h"
#include "irsg/scene/radiance/Fronts.h"
#include "irsg/scene/radiance/SceneRadiometry.h"

namespace irsg {

/// What one kind of surface sends through what lies before it, in one of the outputs of a sampling.
/// A sum of factors F makes of it: constant F_coverage + sum of perFactor[f] F_f.
struct KindRadiance {
    std::span<const double> perFactor; ///< W m-2 sr-1 at each drawn factor of 1
    double constant = 0.0;             ///< whatever the factors are
    double hidden = 0.0;               ///< of the background at the field's centre, that it hides
    double opacity = 0.0;              ///< the same as a part of that background
};

/// The only place where factors meet radiances: products of all transmissivities in front of a
/// surface with its terms, node by node, summed over the outputs of the sampling last. In-band
/// radiances, spectra, images and sums over objects are reductions of it. Kinds are evaluated once
/// each, when they are first asked for; `prepare` does it for many of them, on all cores.
class KindRadiances {
  public:
    /// `radiometry` and `fronts` must live as long; `fronts` may grow.
    KindRadiances(const SceneRadiometry& radiometry, const Fronts& fronts);

    /// Spectral radiance behind the objects at the field's centre, by node; 0 at first. Another one
    /// leaves what surfaces send as it is.
    void setBackground(std::vector<double> background);
    /// Forgets what was evaluated of rows that have become others.
    void forget(const std::vector<int>& rows);
    /// Of the background in an output, W m-2 sr-1.
    double background_W_m2_sr(std::size_t output = 0) const { return inBand_[output]; }

    std::size_t outputs() const { return outputs_; }
    std::size_t factorCount() const { return factorCount_; }

    void prepare(const std::vector<FactorKind>& kinds);
    /// LogicError for a kind that was not prepared.
    KindRadiance of(const FactorKind& kind, std::size_t output = 0) const;

    /// In an output: one value for each term at factor 1 (truth layers).
    std::vector<double> terms(const FactorKind& kind, std::size_t output = 0) const;
    /// By node: weight times what the materials in front let through.
    std::vector<double> passed(int front) const;

  private:
    /// Per factor, then constant.
    std::size_t valuesOfKind() const { return factorCount_ + 1; }
    /// Spectra of a row by value: those of one, added up from its terms.
    struct Row {
        std::vector<std::vector<double>> perFactor; // empty where no term has the factor
        std::vector<double> constant;
    };
    /// Where a kind's numbers lie, by output.
    struct Place {
        bool isKnown = false, hasRoom = false, hasHidden = false;
        std::size_t sent = 0, hidden = 0;
    };
    Place& placeOf(const FactorKind& kind);
    void fillRow(Row& made, int row) const;
    void evaluateSent(const FactorKind& kind, const std::vector<double>& passed,
                      double* into) const;
    void evaluateHidden(const FactorKind& kind, const std::vector<double>& passed,
                        double* into) const;

    const SceneRadiometry& radiometry_;
    const Fronts& fronts_;
    std::size_t outputs_, factorCount_;
    std::vector<Row> rows_;                             // while kinds are prepared
    std::vector<double> background_, inBand_, area_um_; // by node, by output
    std::vector<std::vector<Place>> places_;            // [front][row]
    std::vector<double> sent_, hidden_; // hidden: in-band radiance and part, of each output
};

} // namespace irsg
