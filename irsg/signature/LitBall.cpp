#include "irsg/signature/LitBall.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/SurfaceModels.h"

namespace irsg {

namespace {

constexpr int wavelengths = 16;
constexpr double zenith_K = 230.0, horizon_K = 285.0, ground_K = 295.0;
constexpr double sun_K = 5778.0, throughAtmosphere = 0.7, discSolidAngle_sr = 6.8e-5;
/// What the disc adds to slopes, as in scenes.
constexpr double discSpread = 2.7e-6;
constexpr SurfaceDirection sun{-0.5, 0.70710678118654752, 0.5};
/// Elevations that the sky's radiance is known at, even in their sine.
constexpr std::size_t skyNodes = 12;

double skyTemperature_K(double sine) {
    return horizon_K - (horizon_K - zenith_K) * std::pow(sine, 0.4);
}

std::vector<double> wavelengthsIn(const SpectralRange& band) {
    std::vector<double> all_um;
    for (int i = 0; i < wavelengths; ++i)
        all_um.push_back(band.min_um + band.width_um() * (i + 0.5) / wavelengths);
    return all_um;
}

/// What amounts and light make of a component in the band, W m-2 sr-1.
struct Lights {
    double emitted = 0.0, ofSun_W_m2 = 0.0, sky = 0.0, ground = 0.0;
    std::array<double, skyNodes> skyAt{};

    double from(double sine) const {
        if (sine < 0.0)
            return ground;
        const double place = sine * (skyNodes - 1);
        const auto node = std::min(static_cast<std::size_t>(place), skyNodes - 2);
        const double part = place - static_cast<double>(node);
        return (1.0 - part) * skyAt[node] + part * skyAt[node + 1];
    }
};

class Outdoors {
  public:
    Outdoors(const Material& material, const SpectralRange& band)
        : model_(surfaceModelOf(material)), lights_(model_ ? model_->components() : 1) {
        for (const double at_um : wavelengthsIn(band)) {
            const double step_um = band.width_um() / wavelengths;
            const auto black = [&](double temperature_K) {
                return step_um * planckRadiance_W_m2_sr_um(at_um, temperature_K);
            };
            const double t = material.transmissivity.at(at_um);
            base_ += (1.0 - t) * black(LitBall::temperature_K) + t * black(horizon_K);
            SurfaceModel::Amounts amounts{material.reflectivityAt(at_um)};
            if (model_)
                amounts = model_->amountsAt(material, at_um);
            for (std::size_t k = 0; k < lights_.size(); ++k) {
                Lights& own = lights_[k];
                own.emitted += amounts[k] * black(LitBall::temperature_K);
                own.ofSun_W_m2 += amounts[k] * throughAtmosphere * discSolidAngle_sr * black(sun_K);
                own.ground += amounts[k] * black(ground_K);
                for (std::size_t node = 0; node < skyNodes; ++node) {
                    const double sine = static_cast<double>(node) / (skyNodes - 1);
                    own.skyAt[node] += amounts[k] * black(skyTemperature_K(sine));
                }
            }
        }
        // Of the sky on the whole, with the sine as weight.
        for (Lights& own : lights_)
            for (int i = 0; i < 32; ++i) {
                const double sine = (i + 0.5) / 32;
                own.sky += own.from(sine) * 2.0 * sine / 32;
            }
    }

    /// Of a place with this normal: x to the right, y up, z to who looks.
    double radianceAt(const SurfaceDirection& normal) const {
        // The surface's axes: its normal, and one in the plane of view.
        const double across = std::hypot(normal.x, normal.y);
        const SurfaceDirection along = across > 1e-9
                                           ? SurfaceDirection{-normal.x * normal.z / across,
                                                              -normal.y * normal.z / across, across}
                                           : SurfaceDirection{1.0, 0.0, 0.0};
        const SurfaceDirection aside{normal.y * along.z - normal.z * along.y,
                                     normal.z * along.x - normal.x * along.z,
                                     normal.x * along.y - normal.y * along.x};
        const SurfaceDirection to{across, 0.0, std::max(normal.z, 1e-4)};
        const SurfaceDirection light{dot(sun, along), dot(sun, aside), dot(sun, normal)};
        const double ofSky = 0.5 * (1.0 + normal.y);
        double sum = base_;
        for (std::size_t k = 0; k < lights_.size(); ++k) {
            const Lights& own = lights_[k];
            const double albedo = model_ ? model_->albedo(k, to.z) : 1.0;
            sum -= albedo * own.emitted;
            if (light.z > 0.0)
                sum += own.ofSun_W_m2 * light.z * brdf(k, to, light);
            if (model_ && model_->hasLobe(k))
                sum += albedo * mirrored(k, to, along, aside, normal);
            else
                sum += albedo * (ofSky * own.sky + (1.0 - ofSky) * own.ground);
        }
        return sum;
    }

  private:
    double brdf(std::size_t k, const SurfaceDirection& to, const SurfaceDirection& from) const {
        if (!model_)
            return 1.0 / pi;
        SlopeSpread spread = SlopeSpread::of(model_->roughness());
        spread.xx += discSpread;
        spread.yy += discSpread;
        return model_->brdf_per_sr(k, to, from, spread);
    }
    /// The mean of what lies in its lobe.
    double mirrored(std::size_t k, const SurfaceDirection& to, const SurfaceDirection& along,
                    const SurfaceDirection& aside, const SurfaceDirection& normal) const {
        double weights = 0.0, sum = 0.0;
        for (const SurfaceDirection& facet : model_->facets()) {
            const double weight = model_->facetWeight(k, to, facet);
            const SurfaceDirection from = irsg::mirrored(to, facet);
            weights += weight;
            if (weight != 0.0)
                sum += weight *
                       lights_[k].from(from.x * along.y + from.y * aside.y + from.z * normal.y);
        }
        return weights != 0.0 ? sum / weights : lights_[k].sky;
    }

    std::shared_ptr<const SurfaceModel> model_;
    double base_ = 0.0;
    std::vector<Lights> lights_;
};

} // namespace

LitBall litBall(const Material& material, const SpectralRange& band, int size_px) {
    const Outdoors outdoors(material, band);
    LitBall ball{size_px, {}};
    for (int row = 0; row < size_px; ++row)
        for (int column = 0; column < size_px; ++column) {
            const double x = (2.0 * column + 1.0) / size_px - 1.0;
            const double y = 1.0 - (2.0 * row + 1.0) / size_px;
            const double square = x * x + y * y;
            ball.radiance_W_m2_sr.push_back(
                square < 1.0 ? outdoors.radianceAt({x, y, std::sqrt(1.0 - square)})
                             : std::numeric_limits<double>::quiet_NaN());
        }
    return ball;
}

double bandReflectance(const Material& material, double cosine, const SpectralRange& band) {
    double sum = 0.0;
    for (const double at_um : wavelengthsIn(band))
        sum += reflectanceOverAngle(material, cosine, at_um);
    return sum / wavelengths;
}

} // namespace irsg
