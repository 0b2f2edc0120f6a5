// Samples of the program: as they are, read two-sided and as another format.
#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <stdexcept>

#include "benchmarks/exchange/ExchangeCases.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/SignatureFile.h"
#include "tests/support/TracedScene.h"

namespace irsg::bench {

using namespace test;

namespace {

/// Binary STL of the triangles of a model, model axes, without some materials.
void writeStl(const Model& model, const std::set<int>& absentMaterials,
              const std::filesystem::path& file) {
    std::vector<char> bytes(84, ' ');
    const auto put = [&](const void* from, std::size_t count) {
        const char* begin = static_cast<const char*>(from);
        bytes.insert(bytes.end(), begin, begin + count);
    };
    std::uint32_t count = 0;
    for (const Mesh::Part& part : model.mesh()->parts)
        for (std::size_t i = 0; i + 2 < part.triangles.size(); i += 3) {
            if (absentMaterials.contains(part.codes.material))
                continue;
            const std::array<float, 3> noNormal{};
            put(noNormal.data(), sizeof noNormal);
            for (std::size_t k = 0; k < 3; ++k)
                put(part.vertices[part.triangles[i + k]].data(), sizeof(Float3));
            const std::uint16_t attribute = 0;
            put(&attribute, sizeof attribute);
            ++count;
        }
    std::copy_n(reinterpret_cast<const char*>(&count), sizeof count, bytes.begin() + 80);
    std::ofstream stream(file, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!stream)
        throw std::runtime_error(file.string() + ": cannot be written");
}

std::vector<ExchangeCase> ofSample(const std::string& name) {
    const std::filesystem::path folder = std::filesystem::path(SMAT_SOURCE_DIR) / "samples" / name,
                                file = folder / (name + ".flt");
    std::set<int> absent; // plumes and propeller discs
    for (const auto& [index, material] :
         loadSignatureFile(folder / (name + ".sigdb")).database.materials)
        if (material.transmissivity.at(4.0) > 0.5)
            absent.insert(index);
    ModelOptions twoSided;
    twoSided.forceTwoSided = true;
    const std::shared_ptr<const Model> asItIs = Model::load(file);
    const std::filesystem::path stl =
        std::filesystem::temp_directory_path() / ("bench_exchange-" + name + ".stl");
    writeStl(*asItIs, absent, stl);
    const std::array<std::pair<std::string, std::shared_ptr<const Model>>, 3> models{
        {{"as it is", asItIs},
         {"two-sided", Model::load(file, twoSided)},
         {"as STL", Model::load(stl)}}};
    std::filesystem::remove(stl);
    std::vector<ExchangeCase> cases;
    for (const double azimuth_deg : {45.0, 180.0})
        for (const auto& [variant, model] : models) {
            cases.push_back(
                seenFrom(name, variant + ", " + std::to_string(static_cast<int>(azimuth_deg)) + "°",
                         {greyEntity(model, 0.7, 330.0, absent)}, azimuth_deg, 10.0));
            cases.back().skin_m = skinOfModel_m(*model);
        }
    return cases;
}

/// An aircraft, with another 640 m beside it and without.
std::vector<ExchangeCase> flyby() {
    const std::shared_ptr<const Model> model =
        Model::load(std::filesystem::path(SMAT_SOURCE_DIR) / "samples/turboprop4/turboprop4.flt");
    std::vector<ExchangeCase> cases;
    for (const double yaw_deg : {0.0, 90.0})
        for (const bool isAlone : {true, false}) {
            Entity far = greyEntity(model, 0.7, 330.0);
            far.pose.attitude.yaw_rad = radians(yaw_deg);
            std::vector<Entity> entities{far};
            if (!isAlone) {
                Entity near = far;
                near.pose.position_m = far.pose.position_m + Vec3{600.0, -220.0, 30.0};
                entities.push_back(near);
            }
            cases.push_back(seenFrom("flyby",
                                     std::string(isAlone ? "alone" : "another at 640 m") +
                                         ", yaw " + std::to_string(static_cast<int>(yaw_deg)) + "°",
                                     entities, 180.0, 0.0));
            cases.back().body = 0;
            cases.back().skin_m = skinOfModel_m(*model);
        }
    return cases;
}

} // namespace

std::vector<NamedCases> sampleCases() {
    return {{"heron", [] { return ofSample("heron"); }},
            {"corvette", [] { return ofSample("corvette"); }},
            {"flyby", flyby}};
}

} // namespace irsg::bench
