#pragma once

#include <vector>

#include "tools/atmosphere-tables/lines/Line.h"

namespace irsg::lbl {

/// Wigner's 3j symbol (a b c; 0 0 0) and 6j symbol {a b c; d e f} of whole numbers, at most 300.
double wigner3j(int a, int b, int c);
double wigner6j(int a, int b, int c, int d, int e, int f);

/// Energy-corrected sudden approximation of collisions with one perturber: rates of the rotation
/// 0 -> L go with (L (L + 1))^-lambda exp(-beta E(L) / kT), corrected for the turn during a
/// collision over `length_m`.
struct CollisionLaw {
    double rate_per_cm_atm, lambda, beta, length_m, reducedMass_g;
    double share; ///< of the perturber in the gas
};

/// The band of nu3 of 12C16O2 from its ground state, with the relaxation matrix of collisions that
/// turn one line into another (N. Rodrigues et al. 1999, J. Quant. Spectrosc. Radiat. Transfer 61,
/// 153; F. Niro, C. Boulet and J.-M. Hartmann 2004, ibid. 88, 483), scaled line by line, the
/// strongest first, so that collisions move no dipole (Niro et al.). Widths and strengths are those
/// of `list`; for tests.
class LineMixing {
  public:
    LineMixing(const LineList& list, double temperature_K, double pressure_atm,
               const std::vector<CollisionLaw>& laws);

    std::size_t count() const { return lines_.size(); }
    /// What the scaling multiplied the rates by, of each line; 1 where rates add up to widths.
    const std::vector<double>& scales() const { return scales_; }
    /// The largest of sum d W over d gamma, which collisions that move no dipole make 0.
    double leak() const;
    /// Absorption of the band, cm2 per molecule: with the matrix, of Lorentzian lines and of such
    /// with Perrin and Hartmann's wings.
    double mixed_cm2(double wavenumber_per_cm) const;
    double lorentz_cm2(double wavenumber_per_cm) const;
    double winged_cm2(double wavenumber_per_cm) const;

  private:
    struct Transition {
        int lower, upper; ///< J
        double centre_per_cm, intensity, width_per_cm, population, dipole;
    };
    double temperature_K_, pressure_atm_;
    std::vector<Transition> lines_;
    std::vector<double> matrix_; ///< W, cm-1/atm, [to][from]
    std::vector<double> scales_;
};

} // namespace irsg::lbl
