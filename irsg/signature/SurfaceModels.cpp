#include "irsg/signature/SurfaceModels.h"

#include <algorithm>
#include <map>
#include <mutex>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/FacetModel.h"
#include "irsg/signature/SandfordRobertson.h"
#include "irsg/signature/ShellTarget.h"
#include "irsg/signature/TabulatedModel.h"

namespace irsg {

namespace {

/// Of what is kept of models.
constexpr std::size_t mostModels = 64;

/// A model by its name: what its components follow from, and how it is made.
struct Kind {
    const char* name;
    std::vector<double> (*keyOf)(const Material& material);
    std::shared_ptr<const SurfaceModel> (*make)(const Material& material);
    std::vector<std::string> fields;
};

template <typename Model>
std::shared_ptr<const SurfaceModel> made(const Material& material) {
    return std::make_shared<const Model>(material);
}

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all = {
        {"ggx",
         FacetModel::keyOf,
         made<FacetModel>,
         {"roughness", "refractiveIndex", "extinction"}},
        {"beckmann",
         FacetModel::keyOf,
         made<FacetModel>,
         {"roughness", "refractiveIndex", "extinction"}},
        {"sandfordRobertson",
         SandfordRobertson::keyOf,
         made<SandfordRobertson>,
         {"roughness", "grazingFactor", "diffuseReflectivity"}},
        {"shellTarget",
         ShellTarget::keyOf,
         made<ShellTarget>,
         {"roughness", "refractiveIndex", "extinction", "diffuseReflectivity", "volumeReflectivity",
          "shadowTau_deg", "shadowOmega_deg"}},
        {"tabulated", TabulatedModel::keyOf, made<TabulatedModel>, {"reflectanceTable"}}};
    return all;
}

} // namespace

const std::vector<std::string>& surfaceModelNames() {
    static const std::vector<std::string> all = [] {
        std::vector<std::string> list;
        for (const Kind& kind : kinds())
            list.emplace_back(kind.name);
        return list;
    }();
    return all;
}

const std::vector<std::string>& fieldsOfSurfaceModel(const std::string& name) {
    static const std::vector<std::string> none;
    const auto kind =
        std::ranges::find(kinds(), name, [](const Kind& one) { return std::string(one.name); });
    return kind == kinds().end() ? none : kind->fields;
}

bool isSurfaceModel(const std::string& name) {
    return name.empty() ||
           std::ranges::find(surfaceModelNames(), name) != surfaceModelNames().end();
}

std::shared_ptr<const SurfaceModel> surfaceModelOf(const Material& material) {
    if (material.surfaceModel.empty())
        return nullptr;
    const auto kind = std::ranges::find(kinds(), material.surfaceModel,
                                        [](const Kind& one) { return std::string(one.name); });
    if (kind == kinds().end()) {
        std::string expected;
        for (const std::string& name : surfaceModelNames())
            expected += "'" + name + "', ";
        throw InputError(Diagnostic{material.name, "surfaceModel",
                                    "'" + material.surfaceModel + "'", expected + "or nothing"});
    }
    if (!(material.roughness >= leastRoughness && material.roughness <= 1.0))
        throw InputError(Diagnostic{material.name, "roughness", numberText(material.roughness),
                                    "a number from 0.001 to 1"});
    const std::vector<double> key = kind->keyOf(material);
    static std::mutex access;
    static std::map<std::vector<double>, std::shared_ptr<const SurfaceModel>> kept;
    const std::lock_guard lock(access);
    const auto found = kept.find(key);
    if (found != kept.end())
        return found->second;
    if (kept.size() >= mostModels)
        kept.clear();
    return kept[key] = kind->make(material);
}

double reflectanceOverAngle(const Material& material, double cosine, double wavelength_um) {
    const auto model = surfaceModelOf(material);
    if (!model)
        return material.reflectivityAt(wavelength_um);
    const SurfaceModel::Amounts amounts = model->amountsAt(material, wavelength_um);
    double sum = 0.0;
    for (std::size_t k = 0; k < model->components(); ++k)
        sum += amounts[k] * model->albedo(k, cosine);
    return sum;
}

double brdf_per_sr(const Material& material, const SurfaceDirection& to,
                   const SurfaceDirection& from, double wavelength_um) {
    const auto model = surfaceModelOf(material);
    if (!model)
        return material.reflectivityAt(wavelength_um) / pi;
    const SurfaceModel::Amounts amounts = model->amountsAt(material, wavelength_um);
    double sum = 0.0;
    for (std::size_t k = 0; k < model->components(); ++k)
        sum += amounts[k] * model->brdf_per_sr(k, to, from);
    return sum;
}

} // namespace irsg
