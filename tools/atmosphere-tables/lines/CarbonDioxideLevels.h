#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "tools/atmosphere-tables/lines/Line.h"

namespace irsg::lbl {

/// Energies of the rotational levels of one vibrational state, with l-doubling taken apart:
/// E(J) = sum of c_i X^i with X = J (J + 1), which are G, B, -D and H.
class RotationalTerm {
  public:
    /// Least squares through energies (cm-1) of levels J; needs at least eight levels. Levels off
    /// by more than 0.05 cm-1 and six times the median are set aside once (perturbed ones).
    static std::optional<RotationalTerm> fit(const std::map<int, double>& energies_per_cm);

    double energy_per_cm(int J) const;
    int highestJ() const { return highestJ_; }
    /// RMS of the levels that were kept, cm-1.
    double residual_per_cm() const { return residual_per_cm_; }

  private:
    std::array<double, 4> coefficients_{};
    int highestJ_ = 0;
    double residual_per_cm_ = 0.0;
};

/// Half widths, shift and exponent of a line of CO2 by its |m| (m = -J for P, J for Q and J + 1 for
/// R lines).
struct WidthOfM {
    double airWidth_cm_atm = 0.0, selfWidth_cm_atm = 0.0, widthExponent = 0.0,
           airShift_cm_atm = 0.0;

    void applyTo(Line& line) const;
};

/// Levels of the isotopologues of CO2, found from assigned lines: the lower state of a line has its
/// E'', the upper one E'' + nu.
class CarbonDioxideLevels {
  public:
    /// HITRAN records (Rothman et al. 2005, classes of quanta for CO2); those without assignment
    /// are passed over. `file` stands for their origin in errors: InputError where there are fewer
    /// than a hundred assigned lines.
    CarbonDioxideLevels(const std::vector<std::string>& records, const std::string& file);

    /// The term of a state such as "10012" (v1 v2 l2 v3 r) of an isotopologue, e or f levels; null
    /// where fewer than eight of its levels are known.
    const RotationalTerm* term(int isotopologue, const std::string& state, char symmetry) const;
    std::size_t termCount() const { return terms_.size(); }

    /// Mean of the assigned lines of that |m|, clamped beyond the largest.
    WidthOfM widths(int m) const;

  private:
    std::map<std::tuple<int, std::string, char>, RotationalTerm> terms_;
    std::vector<WidthOfM> widths_;
};

} // namespace irsg::lbl
