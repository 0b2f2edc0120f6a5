#include "benchmarks/exchange/WrittenScene.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <stdexcept>
#include <tuple>
#include <vector>

#include <nlohmann/json.hpp>

#include "irsg/radiometry/Units.h"
#include "tests/support/TracedScene.h"

namespace irsg::bench {

using namespace test;

namespace {

/// In single precision about the centre of the bodies, as the reader has them.
void writePly(const std::vector<TracedTriangle>& triangles, const Vec3& centre_m,
              const std::filesystem::path& file) {
    std::ofstream stream(file, std::ios::binary);
    stream << "ply\nformat binary_little_endian 1.0\nelement vertex " << 3 * triangles.size()
           << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
           << triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const TracedTriangle& triangle : triangles)
        for (const Vec3& corner : triangle.corners_m) {
            const Vec3 from = corner - centre_m;
            const std::array<float, 3> at{static_cast<float>(from.x), static_cast<float>(from.y),
                                          static_cast<float>(from.z)};
            stream.write(reinterpret_cast<const char*>(at.data()), sizeof at);
        }
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(triangles.size()); ++i) {
        const std::array<std::int32_t, 3> corners{3 * i, 3 * i + 1, 3 * i + 2};
        stream.put(3);
        stream.write(reinterpret_cast<const char*>(corners.data()), sizeof corners);
    }
    if (!stream)
        throw std::runtime_error(file.string() + ": cannot be written");
}

nlohmann::json listOf(const Vec3& v) {
    return {v.x, v.y, v.z};
}

} // namespace

void writeScene(const ExchangeCase& one, const Judged& known, const std::filesystem::path& folder) {
    if (one.place_m || one.body || one.isLitAround())
        return; // the intensity of all bodies, by themselves and the sun
    std::filesystem::create_directories(folder);
    std::size_t number = 0;
    while (std::filesystem::exists(folder / (std::to_string(number) + ".json")))
        ++number;
    const std::vector<TracedTriangle> triangles = tracedOf(sceneOf(one), band());
    Vec3 centre_m{}, lowest{1e300, 1e300, 1e300}, highest = lowest * -1.0;
    for (const TracedTriangle& triangle : triangles)
        for (const Vec3& corner : triangle.corners_m) {
            lowest = {std::min(lowest.x, corner.x), std::min(lowest.y, corner.y),
                      std::min(lowest.z, corner.z)};
            highest = {std::max(highest.x, corner.x), std::max(highest.y, corner.y),
                       std::max(highest.z, corner.z)};
        }
    centre_m = (lowest + highest) * 0.5;
    std::map<std::tuple<double, double, bool>, std::vector<TracedTriangle>> kinds;
    for (const TracedTriangle& triangle : triangles)
        kinds[{triangle.emitted_W_m2_sr, triangle.reflectivity, triangle.isTwoSided}].push_back(
            triangle);
    nlohmann::json document{
        {"name", one.name},
        {"variant", one.variant},
        {"towards_viewer", listOf(direction(radians(one.azimuth_deg), radians(one.elevation_deg)))},
        {"towards_sun", listOf(direction(one.sun.azimuth_rad, one.sun.elevation_rad))},
        {"sun_W_m2", one.sun_W_m2},
        {"radius_m", 0.5 * length(highest - lowest)},
        {"bounces", one.bounces},
        {"truth_W_sr", known.truth_W_sr},
        {"truth_error_W_sr", known.truthError_W_sr},
        {"library_W_sr", known.library_W_sr},
        {"stated_error_W_sr", known.statedError_W_sr},
        {"library_s", known.library_s},
        {"kinds", nlohmann::json::array()}};
    for (const auto& [kind, facets] : kinds) {
        const std::string name =
            std::to_string(number) + "-" + std::to_string(document["kinds"].size()) + ".ply";
        writePly(facets, centre_m, folder / name);
        document["kinds"].push_back({{"file", name},
                                     {"emitted_W_m2_sr", std::get<0>(kind)},
                                     {"reflectivity", std::get<1>(kind)},
                                     {"two_sided", std::get<2>(kind)}});
    }
    const std::filesystem::path file = folder / (std::to_string(number) + ".json");
    std::ofstream stream(file);
    stream << document.dump(1) << '\n';
    if (!stream)
        throw std::runtime_error(file.string() + ": cannot be written");
}

} // namespace irsg::bench
