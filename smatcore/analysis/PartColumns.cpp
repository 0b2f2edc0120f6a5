#include "smatcore/analysis/PartColumns.h"

#include <set>

#include "smatcore/data/ColumnName.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

template <typename Entries>
std::string nameIn(const Entries& entries, int index) {
    const auto found = entries.find(index);
    return found == entries.end() ? std::string() : found->second.name;
}

} // namespace

PartsBy partsByOf(const Settings& settings) {
    const std::string& word = settings[key::renderParts];
    return word == "temperature" ? PartsBy::temperature
           : word == "material"  ? PartsBy::material
                                 : PartsBy::none;
}

std::vector<ObjectPart> partsOf(const irsg::Entity& entity, PartsBy by) {
    if (by == PartsBy::none || !entity.model)
        return {};
    const bool isByTemperature = by == PartsBy::temperature;
    std::set<int> indices;
    for (const auto& [codes, use] : entity.model->codes())
        indices.insert(isByTemperature ? codes.temperature : codes.material);
    std::vector<std::string> labels;
    for (const int index : indices) {
        std::string label;
        if (entity.database)
            label = isByTemperature ? nameIn(entity.database->temperatures, index)
                                    : nameIn(entity.database->materials, index);
        labels.push_back(label.empty() ? (isByTemperature ? "temperature " : "material ") +
                                             std::to_string(index)
                                       : label);
    }
    labels = distinctLabels(std::move(labels));
    std::vector<ObjectPart> parts;
    for (const int index : indices)
        parts.push_back({index, labels[parts.size()]});
    return parts;
}

irsg::SurfaceRadiometry sumOfPart(const irsg::ObjectRadiometry& object, PartsBy by, int index) {
    irsg::SurfaceRadiometry sum;
    for (const irsg::SurfaceRadiometry& surface : object.surfaces) {
        if ((by == PartsBy::temperature ? surface.temperature : surface.material) != index)
            continue;
        sum.intensity_W_sr += surface.intensity_W_sr;
        sum.contrastIntensity_W_sr += surface.contrastIntensity_W_sr;
        sum.irradiance_W_m2 += surface.irradiance_W_m2;
        sum.solidAngle_sr += surface.solidAngle_sr;
    }
    return sum;
}

} // namespace smat
