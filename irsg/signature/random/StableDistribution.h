#pragma once

#include <vector>

#include "irsg/signature/random/LogTails.h"

namespace irsg {

/// Levy's alpha-stable distribution with the characteristic function
///   exp(-|t|^alpha (1 - i beta sign(t) tan(pi alpha / 2))), alpha != 1
/// (parametrisation 1 of Nolan, "Numerical calculation of stable densities and distribution
/// functions", Stochastic Models 13, 1997), and Cauchy's for alpha = 1. alpha = 2 is normal with
/// variance 2; alpha = 1/2, beta = 1 is Levy's own.
///
/// Nolan's integral (theorem 1) gives the tail itself, never 1 less the rest, so that far tails
/// keep their digits. The double exponential rule is halved until its sum stands still to 1e-10
/// (the error is then below 1e-12); what it needs of the angles is computed once.
class StableDistribution {
  public:
    /// `alpha` from 0.5 to 0.9, 1, or 1.1 to 2; `beta` from -1 to 1, 0 for alpha = 1.
    StableDistribution(double alpha, double beta);

    LogTails tails(double z) const;

  private:
    struct Node {
        double logV;   ///< ln V(theta) of Nolan's eq. 3
        double weight; ///< of the integral over theta, divided by pi
    };
    struct Side {
        double mass = 0.0;                     ///< P(Z > 0), of -Z on the other side
        double leastLogV = 0.0;                ///< of all nodes
        std::vector<std::vector<Node>> levels; ///< each the nodes that the level adds
    };
    static Side sideOf(double alpha, double beta);
    /// Tails at z > 0.
    LogTails tailsOf(const Side& side, double z) const;

    double alpha_;
    Side right_, left_;
};

} // namespace irsg
