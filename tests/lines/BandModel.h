#pragma once

#include <vector>

#include "tools/atmosphere-tables/lines/Line.h"
#include "tools/atmosphere-tables/lines/PartitionSums.h"

namespace irsg::lbl {

/// One gas on a level path.
struct GasPath {
    double temperature_K, pressure_hPa;
    double fraction;       ///< mole fraction of the gas
    double column_per_cm2; ///< molecules of the gas
};

/// A statistical band model of bins of 1 cm-1 around whole wavenumbers, in the form of MODTRAN's
/// (A. Berk et al., US patent 7,433,806, 2008): in each bin the absorption of lines that are
/// centred in it, as n equal Voigt lines that overlap at random (G. N. Plass 1958, J. Opt. Soc. Am.
/// 48, 690), times that of the tails of lines centred in other bins, up to 25 cm-1 away.
/// Three numbers are read off published values, see PublishedBinsTest: the tail of a line begins
/// `tail_per_cm` from the edge of its bin at least, the line itself stands `edge_per_cm` from it at
/// least, and what lies closer than `together_per_cm` to stronger lines counts less in n = (sum of
/// S / sqrt(C))^2 / sum of S, where C is S and the strength of stronger lines in the bin times 1 -
/// distance / together. Lines far from each other add sqrt(S), such that coincide count as one.
class BandModel {
  public:
    BandModel(const LineList& lines, const PartitionSums& partition, const GasPath& path);

    /// Transmittance of the bin around a whole wavenumber.
    double bin(int centre_per_cm) const;
    /// Mean of bins under a triangle of 10 cm-1 at half maximum.
    double at(int centre_per_cm) const;

    static constexpr double tail_per_cm = 1.0 / 6.0, edge_per_cm = 0.09, together_per_cm = 0.28;

  private:
    struct Strong {
        double centre_per_cm, depth_per_cm, doppler_per_cm, lorentz_per_cm;
    };
    std::vector<Strong> lines_; ///< ascending; strength times column
};

} // namespace irsg::lbl
