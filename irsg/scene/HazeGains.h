#pragma once

#include <memory>
#include <vector>

#include "irsg/radiance/ScaledView.h"
#include "irsg/render/values/RenderReport.h"
#include "irsg/scene/scattering/SceneScattering.h"

namespace irsg {

/// Sums over objects as a picture with haze has them, from those of the direct light. An object
/// adds what it sends and takes off what it hides, each times its gain (HazeGain): every quantity
/// is linear in both, so that bands, spectra and draws of scales keep the picture's number.

/// By entity.
using HazeGains = std::vector<HazeGain>;

/// Gives a report of one band the haze, its errors included.
void addHaze(const HazeGains& gains, RenderReport& report);
/// The same of a spectrum, with the gains of its band: what it adds up to is the band's number.
void addHaze(const HazeGains& gains, IntensitySpectrum& spectrum);
/// What several objects have together: exact for these sums, and as far as all change alike.
HazeGain gainOfAll(const HazeGains& gains, const std::vector<ObjectRadiometry>& direct);

/// A view as a function of scales, with haze.
class HazedScaledView : public ScaledView {
  public:
    HazedScaledView(std::unique_ptr<const ScaledView> direct, const HazeGain& gain)
        : direct_(std::move(direct)), gain_(gain) {}

    std::unique_ptr<Memo> memo() const override { return direct_->memo(); }
    std::size_t size() const override { return direct_->size(); }
    void evaluate(std::span<const double> scales, ScaledValues& values) const override {
        evaluate(scales, values, nullptr);
    }
    void evaluate(std::span<const double> scales, ScaledValues& values, Memo* memo) const override;

  private:
    std::unique_ptr<const ScaledView> direct_;
    HazeGain gain_;
};

} // namespace irsg
