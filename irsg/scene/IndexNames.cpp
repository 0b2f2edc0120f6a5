#include "irsg/scene/IndexNames.h"

#include <algorithm>
#include <map>
#include <string>

namespace irsg {

namespace {

using Names = std::map<int, std::vector<std::string>>;

void addName(Names& names, int index, const std::string& name) {
    std::vector<std::string>& known = names[index];
    if (!name.empty() && std::ranges::find(known, name) == known.end())
        known.push_back(name);
}

void describe(const std::string& plane, const Names& names, RadianceImage& image) {
    if (image.find(plane) == nullptr)
        return;
    for (const auto& [index, list] : names) {
        std::string words;
        for (const std::string& name : list)
            words += (words.empty() ? "" : " / ") + name;
        if (!words.empty())
            image.attributes[plane + "." + std::to_string(index)] = words;
    }
}

} // namespace

void nameIndices(const std::vector<Entity>& entities, RadianceImage& image) {
    Names temperatures, materials, objects;
    for (std::size_t e = 0; e < entities.size(); ++e) {
        const Entity& entity = entities[e];
        addName(objects, static_cast<int>(e), entity.name);
        for (const auto& [codes, use] : entity.model->codes()) {
            if (const TemperatureEntry* entry = temperatureEntry(entity, codes.temperature))
                addName(temperatures, codes.temperature, entry->name);
            if (const Material* material = materialEntry(entity, codes.material))
                addName(materials, codes.material, material->name);
        }
    }
    describe("temperature_index", temperatures, image);
    describe("material_index", materials, image);
    describe("object_index", objects, image);
}

} // namespace irsg
