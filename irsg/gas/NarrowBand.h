#pragma once

namespace irsg {

/// How line strengths are spread within a narrow band whose lines lie at random.
enum class StrengthLaw {
    goody,  ///< exponential (R. M. Goody 1952, Q. J. R. Meteorol. Soc. 78, 165)
    malkmus ///< exponential with a tail of weak lines (W. Malkmus 1967, J. Opt. Soc. Am. 57, 323)
};

/// One gas in one layer at one wavenumber.
struct NarrowBandLayer {
    double depth = 0.0; ///< X: mean absorption coefficient times amount, the limit of weak lines
    double collision = 0.0; ///< half width of collisions over the mean spacing of lines
    double doppler = 0.0;   ///< half width at 1/e of the Doppler profile over the spacing
};

/// Sums over consecutive layers by Curtis and Godson (Ludwig et al. 1973, NASA SP-3080): X, X times
/// collision, X times doppler. Layers that are alike add up to the layer that they make together.
class NarrowBandSum {
  public:
    void add(const NarrowBandLayer& layer) {
        add(layer.depth, layer.depth * layer.collision, layer.depth * layer.doppler);
    }
    /// The same of X, X times collision and X times doppler.
    void add(double depth, double byCollision, double byDoppler) {
        depth_ += depth;
        collision_ += byCollision;
        doppler_ += byDoppler;
    }
    double weakDepth() const { return depth_; }
    /// -ln of the mean transmittance: at most weakDepth(), by curves of growth for collisions and
    /// for Doppler broadening, which NASA SP-3080 (eqs. 5-25, 5-26) combines.
    double opticalDepth(StrengthLaw law) const;

  private:
    double depth_ = 0.0, collision_ = 0.0, doppler_ = 0.0;
};

/// Optical depth of lines that collisions alone broaden: Goody X / sqrt(1 + X / 4a), Malkmus
/// 2a (sqrt(1 + X / a) - 1).
double collisionDepth(StrengthLaw law, double depth, double collision);
/// The same of lines that the Doppler effect alone broadens (NASA SP-3080, section 3.2.5).
double dopplerDepth(StrengthLaw law, double depth, double doppler);

} // namespace irsg
