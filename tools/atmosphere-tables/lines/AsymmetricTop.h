#pragma once

#include <cstddef>
#include <vector>

namespace irsg::lbl {

/// Constants, cm-1, of a vibrational state of a bent molecule XY2: Watson's A-reduced Hamiltonian
/// in representation I^r (J. K. G. Watson 1977, Vibrational Spectra and Structure 6, 1).
struct TopState {
    bool isAntisymmetric = false; ///< of species B1: an odd number of quanta of nu3
    double origin = 0.0;
    double mean = 0.0;  ///< (B + C) / 2
    double axial = 0.0; ///< A - (B + C) / 2
    double deltaJ = 0.0, deltaJK = 0.0, deltaK = 0.0;
    double HJ = 0.0, HJK = 0.0, HKJ = 0.0, HK = 0.0, LK = 0.0, LKKJ = 0.0;
    double half = 0.0; ///< (B - C) / 2
    double smallDeltaJ = 0.0, smallDeltaK = 0.0, hJ = 0.0, hJK = 0.0, hK = 0.0;
};

/// What couples two states, cm-1.
struct TopCoupling {
    std::size_t first = 0, second = 0;
    double coriolis = 0.0; ///< of i Jy, about the axis c
    double tilt = 0.0;     ///< of Jx Jz + Jz Jx
    double anharmonic = 0.0;
};

struct TopLevel {
    double energy_per_cm = 0.0;
    std::size_t state = 0; ///< the one that it is named after
    int J = 0, Ka = 0, Kc = 0;
    std::vector<double> amplitudes; ///< of state s and k, at s (2J + 1) + J + k
};

/// Interacting vibrational states of a molecule XY2 whose atoms Y have no spin (as 16O): only
/// levels with Ka + Kc even exist in symmetric states, odd in antisymmetric ones.
class AsymmetricTop {
  public:
    AsymmetricTop(std::vector<TopState> states, std::vector<TopCoupling> couplings)
        : states_(std::move(states)), couplings_(std::move(couplings)) {}

    std::size_t stateCount() const { return states_.size(); }
    std::vector<TopLevel> levels(int J) const;

  private:
    double element(std::size_t bra, std::size_t ket, int J, int kBra, int kKet) const;

    std::vector<TopState> states_;
    std::vector<TopCoupling> couplings_;
};

/// A part of the electric dipole between two states.
struct TopMoment {
    enum class Axis {
        a, ///< of the band of nu3
        b, ///< of nu1
    };
    std::size_t lower = 0, upper = 0;
    Axis axis = Axis::a;
    double debye = 0.0;
    /// Herman and Wallis: the moment times 1 + linear m + square m^2, m = -J'', 0 or J'' + 1.
    double linear = 0.0, square = 0.0;
};

/// A transition and its line strength, D^2: the square of the moment summed over all M and
/// directions.
struct TopTransition {
    TopLevel lower, upper; ///< without their amplitudes
    double strength_debye2 = 0.0;
};

/// All transitions with lower J up to `highestJ` between the listed states whose energies differ by
/// `from_per_cm` to `to_per_cm`.
std::vector<TopTransition> transitions(const AsymmetricTop& lower, const AsymmetricTop& upper,
                                       const std::vector<TopMoment>& moments, int highestJ,
                                       double from_per_cm, double to_per_cm);

} // namespace irsg::lbl
