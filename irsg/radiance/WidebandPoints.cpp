#include "irsg/radiance/WidebandPoints.h"

#include <algorithm>
#include <cstdio>

#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/radiance/SceneRadiometry.h"

namespace irsg {

namespace {

/// The samples of a spectrum among those of some; null where it is none of them.
const std::vector<double>* samplesOf(const Spectrum& spectrum, const std::vector<Spectrum>& some,
                                     const std::vector<std::vector<double>>& samples) {
    const auto found = std::ranges::find(some, spectrum);
    return found == some.end() ? nullptr : &samples[static_cast<std::size_t>(found - some.begin())];
}

/// What quadrature points are prepared for; `spectra` need to live as long.
CkRequest requestOf(const Environment& environment, const Band& band,
                    const WidebandSpectra& spectra, double largestError) {
    CkRequest request;
    request.largestError = largestError;
    request.band = band;
    request.sun = environment.sun;
    for (const Spectrum& material : spectra.materials)
        request.materials.push_back(&material);
    for (const Spectrum& radiance : spectra.radiances)
        request.radiances.push_back(&radiance);
    return request;
}

} // namespace

WidebandSpectra widebandSpectraOf(const std::vector<Entity>& entities) {
    WidebandSpectra spectra;
    auto add = [](std::vector<Spectrum>& kind, const Spectrum& spectrum) {
        if (!spectrum.isConstant() && std::ranges::find(kind, spectrum) == kind.end())
            kind.push_back(spectrum);
    };
    for (const Entity& entity : entities)
        for (const auto& [codes, use] : entity.model->codes()) {
            if (const Material* material = materialEntry(entity, codes.material)) {
                add(spectra.materials, material->emissivity);
                add(spectra.materials, material->transmissivity);
            }
            if (const TemperatureEntry* entry = temperatureEntry(entity, codes.temperature))
                if (const UserSpectrum* user = userSpectrumOf(entity, *entry))
                    for (const SpectrumComponent& component : user->components)
                        add(spectra.radiances, component.radiance);
        }
    return spectra;
}

WidebandPoints::WidebandPoints(const Environment& environment, const Band& band,
                               WidebandSpectra spectra, double largestError)
    : atmospheres_(environment),
      sun_(environment.sun),
      spectra_(std::move(spectra)),
      largestError_(largestError) {
    auto answer = environment.prepareCk(requestOf(environment, band, spectra_, largestError));
    data_ = std::move(answer.value);
    providedBy_ = std::move(answer.providedBy);
    for (const Spectrum& material : spectra_.materials)
        materialSamples_.push_back(data_->sampled(material));
    for (const Spectrum& radiance : spectra_.radiances)
        radianceSamples_.push_back(data_->sampled(radiance));
}

bool WidebandPoints::areOf(const Environment& environment, const Band& band,
                           const WidebandSpectra& spectra, double largestError) const {
    return atmospheres_.isOf(environment) && sun_ == environment.sun && data_->band() == band &&
           largestError_ == largestError && spectra_ == spectra;
}

std::shared_ptr<const SpectralSampling> WidebandPoints::sampling() const {
    return data_;
}

std::vector<double> WidebandPoints::sampled(const Spectrum& spectrum) const {
    if (spectrum.isConstant())
        return std::vector<double>(data_->size(), spectrum.values().front());
    for (const auto* known : {samplesOf(spectrum, spectra_.materials, materialSamples_),
                              samplesOf(spectrum, spectra_.radiances, radianceSamples_)})
        if (known)
            return *known;
    return data_->sampled(spectrum);
}

std::string WidebandPoints::description() const {
    char errors[128];
    std::snprintf(errors, sizeof errors,
                  " quadrature points, %.2g %% rms and at most %.2g %% off on paths that were not "
                  "trained, of ",
                  100.0 * data_->heldOutRms(), 100.0 * data_->heldOutError());
    return "wideband-ck: " + std::to_string(data_->size()) + errors + providedBy_;
}

} // namespace irsg
