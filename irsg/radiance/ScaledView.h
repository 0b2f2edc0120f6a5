#pragma once

#include <memory>
#include <span>
#include <vector>

#include "irsg/signature/ScalingXml.h"

namespace irsg {

/// One scale that varies, and the range it varies in.
struct ScalingInput {
    int entity = 0; ///< its number in the scene
    ScalingKind kind = ScalingKind::temperature;
    int index = 0; ///< of the entity's signature database
    double least = 1.0, most = 1.0;
};

/// Sums over all objects of a scene: one value each in a band, one per wavenumber of a spectrum.
struct ScaledValues {
    std::vector<double> intensity;         ///< W sr-1, or W sr-1 um-1
    std::vector<double> contrastIntensity; ///< the same
    std::vector<double> irradiance;        ///< of the contrast, W m-2, or W m-2 um-1
};

/// One view of a scene, as a function of the scales of its signature databases: the geometry is
/// drawn and the air is asked once, and what is left of a draw are a few sums. May be used by
/// several threads at a time.
class ScaledView {
  public:
    /// What surfaces added at the last scales of theirs: a draw that differs from earlier ones in a
    /// few scales looks at the surfaces that have them. For one thread at a time.
    class Memo {
      public:
        virtual ~Memo() = default;
    };

    virtual ~ScaledView() = default;
    /// An empty one for this view; null where nothing would be gained.
    virtual std::unique_ptr<Memo> memo() const { return nullptr; }
    /// Number of values of each quantity.
    virtual std::size_t size() const = 0;
    /// `scales` holds one number per input, within its range, in the order of the inputs.
    virtual void evaluate(std::span<const double> scales, ScaledValues& values) const = 0;
    /// The same bit by bit, with a memo of this view (or none).
    virtual void evaluate(std::span<const double> scales, ScaledValues& values, Memo*) const {
        evaluate(scales, values);
    }
};

} // namespace irsg
