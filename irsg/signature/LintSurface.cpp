#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "irsg/radiometry/Units.h"
#include "irsg/signature/Findings.h"
#include "irsg/signature/LintEntries.h"
#include "irsg/signature/SurfaceModels.h"

namespace irsg {

namespace {

/// What measurements of emissivity and of n and k may differ by.
constexpr double closure = 0.02;
/// What reflectance may be above what there is.
constexpr double energyTolerance = 1e-3;
constexpr int anglesLooked = 90;
/// What f may differ by from one way to the other, and up to which angle that is looked at.
constexpr double reciprocityTolerance = 0.02, reciprocityTo_deg = 75.0;

/// The nodes of all its spectra, or one wavelength of a grey one.
std::vector<double> wavelengthsOf(const Material& material) {
    std::vector<double> all_um;
    for (const Spectrum* each :
         {&material.emissivity, &material.transmissivity, &material.refractiveIndex,
          &material.extinction, &material.diffuseReflectivity, &material.volumeReflectivity})
        all_um.insert(all_um.end(), each->wavelengths_um().begin(), each->wavelengths_um().end());
    if (material.surfaceModel == "tabulated")
        all_um.insert(all_um.end(), material.reflectanceTable.wavelengths_um().begin(),
                      material.reflectanceTable.wavelengths_um().end());
    if (all_um.empty())
        all_um.push_back(1.0);
    std::ranges::sort(all_um);
    all_um.erase(std::ranges::unique(all_um).begin(), all_um.end());
    return all_um;
}

bool lintBulk(const Material& material, Findings& findings) {
    bool usable = true;
    for (const auto& [place, spectrum] : {std::pair{".refractiveIndex", &material.refractiveIndex},
                                          std::pair{".extinction", &material.extinction}})
        if (!(spectrum->minimum() >= 0.0)) {
            findings.error(place, numberText(spectrum->minimum()), "values of at least 0");
            usable = false;
        }
    const bool hasIndex = material.refractiveIndex.maximum() > 0.0;
    if (hasIndex && !(material.refractiveIndex.minimum() > 0.0)) {
        findings.error(".refractiveIndex", numberText(material.refractiveIndex.minimum()),
                       "n above 0 at every wavelength");
        usable = false;
    }
    if (!hasIndex && material.extinction.maximum() > 0.0)
        findings.warning(".extinction", "k without n",
                         "a refractive index beside it: alone it has no effect");
    return usable && hasIndex;
}

std::string at(const Material& material, double wavelength_um) {
    return wavelengthsOf(material).size() == 1 ? "" : " at " + numberText(wavelength_um) + " um";
}

/// What a model leaves along the normal, or over the hemisphere where its emissivity is that.
double emissivityAt(const SurfaceModel& model, const Material& material, double wavelength_um) {
    const SurfaceModel::Amounts amounts = model.amountsAt(material, wavelength_um);
    double left = 1.0 - material.transmissivity.at(wavelength_um);
    for (std::size_t k = 0; k < model.components(); ++k)
        left -= amounts[k] * model.albedo(k, 1.0);
    return std::clamp(left, 0.0, 1.0);
}

/// The emissivity of the first page against what n and k or a table say of it.
void lintKirchhoff(int index, const SurfaceModel& model, const Material& material,
                   Findings& findings) {
    double worst = 0.0, where_um = 0.0;
    const std::vector<double> nodes_um = wavelengthsOf(material);
    for (const double node_um : nodes_um) {
        const double off =
            std::abs(material.emissivity.at(node_um) - emissivityAt(model, material, node_um));
        if (off > worst) {
            worst = off;
            where_um = node_um;
        }
    }
    if (worst <= closure)
        return;
    const std::string source = material.surfaceModel == "tabulated"     ? "the table leaves"
                               : material.surfaceModel == "shellTarget" ? "the model leaves"
                                                                        : "n and k leave";
    Finding& found = findings.warning(".emissivity" + at(material, where_um),
                                      numberText(material.emissivity.at(where_um)),
                                      numberText(emissivityAt(model, material, where_um)) +
                                          ", which " + source + " along the normal (it is used)");
    found.remedy = "set the emissivity to what " + source;
    found.repair = onMaterial(index, [nodes_um](Material& to) {
        const auto own = surfaceModelOf(to);
        std::vector<double> values;
        for (const double node_um : nodes_um)
            values.push_back(own ? emissivityAt(*own, to, node_um) : to.emissivity.at(node_um));
        to.emissivity = nodes_um.size() == 1 ? Spectrum::constant(values.front())
                                             : Spectrum(nodes_um, std::move(values));
    });
}

/// Where a deviation is largest.
struct Worst {
    double off = 0.0, where_um = 0.0, angle_deg = 0.0;
    void take(double candidate, double wavelength_um, double at_deg) {
        if (candidate > off)
            *this = {candidate, wavelength_um, at_deg};
    }
};

/// Reflectance over angle, which is the integral of the BRDF, against what is not transmitted.
void lintEnergy(const SurfaceModel& model, const Material& material, Findings& findings) {
    Worst worst{energyTolerance};
    for (const double node_um : wavelengthsOf(material)) {
        const SurfaceModel::Amounts amounts = model.amountsAt(material, node_um);
        const double limit = 1.0 - material.transmissivity.at(node_um);
        for (int angle_deg = 0; angle_deg < anglesLooked; ++angle_deg)
            worst.take(model.reflected(amounts, std::cos(radians(angle_deg))) - limit, node_um,
                       angle_deg);
    }
    if (worst.off > energyTolerance)
        findings.warning(".surfaceModel" + at(material, worst.where_um),
                         "a reflectance that is " + rounded(worst.off) + " above 1 - t at " +
                             numberText(worst.angle_deg) + " deg from the normal",
                         "no more than falls on it");
}

/// f(a, b) against f(b, a), in parts of the mean of both, where either counts.
void lintReciprocity(const SurfaceModel& model, const Material& material, Findings& findings) {
    Worst worst;
    const auto direction = [](double angle_deg, double azimuth_deg) {
        const double sine = std::sin(radians(angle_deg));
        return SurfaceDirection{sine * std::cos(radians(azimuth_deg)),
                                sine * std::sin(radians(azimuth_deg)),
                                std::cos(radians(angle_deg))};
    };
    for (const double node_um : wavelengthsOf(material)) {
        const SurfaceModel::Amounts amounts = model.amountsAt(material, node_um);
        const auto brdf = [&](const SurfaceDirection& to, const SurfaceDirection& from) {
            double sum = 0.0;
            for (std::size_t k = 0; k < model.components(); ++k)
                sum += amounts[k] * model.brdf_per_sr(k, to, from);
            return sum;
        };
        for (double a_deg = 5.0; a_deg <= reciprocityTo_deg; a_deg += 10.0)
            for (double b_deg = a_deg + 10.0; b_deg <= reciprocityTo_deg; b_deg += 10.0)
                for (double azimuth_deg = 0.0; azimuth_deg <= 180.0; azimuth_deg += 30.0) {
                    const SurfaceDirection a = direction(a_deg, 0.0),
                                           b = direction(b_deg, azimuth_deg);
                    const double there = brdf(a, b), back = brdf(b, a);
                    // Less than a thousandth of a white surface counts for nothing.
                    if (there + back > 2e-3 / pi)
                        worst.take(2.0 * std::abs(there - back) / (there + back), node_um, b_deg);
                }
    }
    if (worst.off > reciprocityTolerance)
        findings.warning(
            ".surfaceModel" + at(material, worst.where_um),
            "a BRDF that is not reciprocal: " + rounded(100.0 * worst.off) +
                " % between light from and to " + numberText(worst.angle_deg) + " deg",
            material.surfaceModel == "sandfordRobertson"
                ? "as the model was published; ggx, beckmann and shellTarget are reciprocal"
                : "at most 2 % in a measurement: glints differ by as much");
}

/// What is emitted and reflected diffusely has to leave something for the lobe.
void lintSandfordRobertson(const SurfaceModel& model, const Material& material,
                           Findings& findings) {
    Worst worst;
    for (const double node_um : wavelengthsOf(material)) {
        const double g = model.meanAlbedo(1); // G
        worst.take((material.emissivity.at(node_um) + material.diffuseReflectivity.at(node_um)) /
                           g -
                       (1.0 - material.transmissivity.at(node_um)),
                   node_um, 0.0);
    }
    if (worst.off > energyTolerance)
        findings.warning(".diffuseReflectivity" + at(material, worst.where_um),
                         "(emissivity + diffuse reflectivity) / G = " +
                             rounded(1.0 - material.transmissivity.at(worst.where_um) + worst.off),
                         "at most 1 - t along the normal, where the lobe has what is left");
}

} // namespace

void lintSurface(int index, const Material& material, Findings& findings) {
    const bool hasIndex = lintBulk(material, findings);
    const std::string& model = material.surfaceModel;
    if (model.empty()) {
        if (hasIndex)
            findings.warning(".refractiveIndex", "n and k of a Lambertian surface",
                             "a surface model: without one they have no effect");
        return;
    }
    if (material.nAngleFactor > 0.0)
        findings.warning(".nAngleFactor", numberText(material.nAngleFactor),
                         "0: with a surface model emissivity over angle follows from it, and N "
                         "has no effect");
    if (model == "tabulated" && material.reflectanceTable.empty())
        findings.error(".reflectanceTable", "no table", "one, which this model is made of");
    if (model == "shellTarget" && !hasIndex)
        findings.error(".refractiveIndex", "0", "n and k, which this model is made of");
    const bool hasNumbers = [&] {
        for (const double number : {material.roughness, material.grazingFactor,
                                    material.shadowTau_deg, material.shadowOmega_deg})
            if (!std::isfinite(number))
                return false;
        return material.roughness >= leastRoughness && material.roughness <= 1.0 &&
               material.grazingFactor >= 0.0 && material.grazingFactor <= 1.0 &&
               material.shadowTau_deg > 0.0 && material.shadowOmega_deg > 0.0;
    }();
    const bool isUsable = isSurfaceModel(model) && hasNumbers &&
                          (hasIndex || material.refractiveIndex.maximum() == 0.0) &&
                          (model != "tabulated" || !material.reflectanceTable.empty()) &&
                          (model != "shellTarget" || hasIndex);
    if (!isUsable)
        return;
    const auto made = surfaceModelOf(material);
    if (material.hasIndex() || model == "tabulated")
        lintKirchhoff(index, *made, material, findings);
    if (model == "sandfordRobertson")
        lintSandfordRobertson(*made, material, findings);
    lintEnergy(*made, material, findings);
    lintReciprocity(*made, material, findings);
}

} // namespace irsg
