#include "irsg/atmosphere/ck/SensorCkData.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "irsg/atmosphere/ck/CkTraining.h"
#include "irsg/core/CacheStore.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"

namespace irsg {

SensorCkData::SensorCkData(const CkNodes& nodes, const CkRequest& request,
                           const SparseWeights& chosen)
    : band_(request.band) {
    std::vector<double> wavelengths_um, weights_um;
    // Nodes ascend in wavenumber; points ascend in wavelength.
    for (std::size_t i = chosen.columns.size(); i-- > 0;) {
        const std::size_t node = chosen.columns[i];
        nodes_.nodes.push_back(nodes.set.nodes[node]);
        nodes_.wavenumbers_per_cm.push_back(nodes.set.wavenumbers_per_cm[node]);
        wavelengths_um.push_back(nodes.wavelength_um(node));
        weights_um.push_back(chosen.weights[i]);
        hats_.push_back(nodes.hat(node));
    }
    setNodes(std::move(wavelengths_um), std::move(weights_um), request.band.range());
    largestError_ = chosen.largestError;
    rmsError_ = chosen.rmsError;
}

SensorCkData SensorCkData::prepare(const RadiativeTransfer& transfer, const CkRequest& request) {
    const CkAtmosphere air = ckAtmosphereOf(transfer, request.band);
    CkErrors heldOut;
    const SparseWeights chosen = trainedPoints(air, request, &heldOut);
    SensorCkData data(air.nodes, request, chosen);
    data.heldOutError_ = heldOut.largest;
    data.heldOutRms_ = heldOut.rms;
    return data;
}

SensorCkData SensorCkData::prepare(const CkAtmosphere& known, const Atmosphere& air,
                                   const CkRequest& request) {
    SensorCkData data(known.nodes, request, trainedPoints(known, request));
    const CkErrors heldOut = heldOutErrors(air, data, request, known.heldOut);
    data.heldOutError_ = heldOut.largest;
    data.heldOutRms_ = heldOut.rms;
    return data;
}

void addTo(CacheKey& key, const CkRequest& request) {
    key.add(request.band.range().min_um).add(request.band.range().max_um);
    addTo(key, request.band.response());
    key.add(request.sun.azimuth_rad).add(request.sun.elevation_rad).add(request.sun.distance_au);
    key.add(static_cast<double>(request.paths.size()));
    for (const AtmosphericPath& path : request.paths)
        key.add(path.sensorAltitude_m)
            .add(path.targetAltitude_m)
            .add(path.range_m)
            .add(path.azimuth_rad);
    for (const auto* kind : {&request.materials, &request.radiances}) {
        key.add(static_cast<double>(kind->size()));
        for (const Spectrum* spectrum : *kind)
            addTo(key, *spectrum);
    }
    key.add(request.largestError).add(static_cast<double>(request.mostPoints));
}

void addTo(CacheKey& key, const Spectrum& spectrum) {
    key.add(spectrum.wavelengths_um()).add(spectrum.values());
}

std::string SensorCkData::cacheText() const {
    CacheKey text;
    text.add(static_cast<double>(size()));
    for (const double error : {largestError_, rmsError_, heldOutError_, heldOutRms_})
        text.add(error);
    for (std::size_t i = 0; i < size(); ++i)
        text.add(static_cast<double>(nodes_.nodes[i]))
            .add(nodes_.wavenumbers_per_cm[i])
            .add(weights_um()[i]);
    return text.text() + "end";
}

std::optional<SensorCkData> SensorCkData::fromCached(const CkNodes& nodes, const Band& band,
                                                     const std::string& text) {
    std::istringstream words(text);
    auto number = [&] {
        std::string word;
        words >> word;
        const std::optional<double> value = parseNumber(word);
        if (!value)
            words.setstate(std::ios::failbit);
        return value.value_or(0.0);
    };
    SensorCkData data(band);
    const double count = number();
    for (double* error :
         {&data.largestError_, &data.rmsError_, &data.heldOutError_, &data.heldOutRms_})
        *error = number();
    if (!words || !(count >= 1.0) || count > static_cast<double>(nodes.size()))
        return std::nullopt;

    std::vector<double> wavelengths_um, weights_um;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const double node = number(), wavenumber_per_cm = number(), weight_um = number();
        const auto found =
            std::ranges::lower_bound(nodes.set.wavenumbers_per_cm, wavenumber_per_cm);
        auto at = static_cast<std::size_t>(found - nodes.set.wavenumbers_per_cm.begin());
        while (at < nodes.size() && nodes.set.wavenumbers_per_cm[at] == wavenumber_per_cm &&
               static_cast<double>(nodes.set.nodes[at]) != node)
            ++at;
        if (!words || at == nodes.size() || nodes.set.wavenumbers_per_cm[at] != wavenumber_per_cm ||
            !(weight_um > 0.0) ||
            (!wavelengths_um.empty() && nodes.wavelength_um(at) < wavelengths_um.back()))
            return std::nullopt;
        data.nodes_.nodes.push_back(nodes.set.nodes[at]);
        data.nodes_.wavenumbers_per_cm.push_back(wavenumber_per_cm);
        wavelengths_um.push_back(nodes.wavelength_um(at));
        weights_um.push_back(weight_um);
        data.hats_.push_back(nodes.hat(at));
    }
    std::string end;
    words >> end;
    if (end != "end")
        return std::nullopt;
    data.setNodes(std::move(wavelengths_um), std::move(weights_um), band.range());
    return data;
}

std::vector<double> SensorCkData::sampled(const Spectrum& spectrum) const {
    std::vector<double> means;
    for (const Spectrum& hat : hats_) {
        // The hat is cut to the band.
        const SpectralRange range{std::max(hat.wavelengths_um().front(), band_.range().min_um),
                                  std::min(hat.wavelengths_um().back(), band_.range().max_um)};
        const Spectrum* factors[] = {&hat, &spectrum};
        means.push_back(integrateProduct(factors, range) /
                        integrateProduct(std::span(factors, 1), range));
    }
    return means;
}

} // namespace irsg
