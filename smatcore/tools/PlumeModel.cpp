#include "smatcore/tools/PlumeModel.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/gas/FieldWalls.h"
#include "irsg/gas/FieldZones.h"
#include "irsg/gas/GasByTemperature.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/tools/GasEntries.h"

namespace smat {

namespace {

/// Closed surfaces as a Wavefront file, whose y is up and whose -z is our nose.
class ObjectText {
  public:
    explicit ObjectText(int sides)
        // A polygon as large as the circle.
        : sides_(sides),
          wider_(std::sqrt(2.0 * irsg::pi / (sides * std::sin(2.0 * irsg::pi / sides)))) {}

    /// Of a field, turned upwards.
    void add(const std::string& material, const irsg::FieldWalls::Surface& surface,
             double elevation_deg) {
        begin(material);
        const double cosine = std::cos(irsg::radians(elevation_deg));
        const double sine = std::sin(irsg::radians(elevation_deg));
        const int before = count_ + 1;
        for (const auto& [x_m, y_m, z_m] : surface.vertices_m) {
            ++count_;
            text_ += fmt::format("v {:.9g} {:.9g} {:.9g}\n", y_m, x_m * sine + z_m * cosine,
                                 x_m * cosine - z_m * sine);
        }
        for (const auto& [a, b, c] : surface.triangles)
            addFace(before + static_cast<int>(a), before + static_cast<int>(b),
                    before + static_cast<int>(c));
    }
    /// Of revolution.
    void add(const std::string& material, const std::vector<std::array<double, 2>>& outline) {
        begin(material);
        std::vector<int> first; // vertex of each ring
        for (const auto& [x_m, r_m] : outline) {
            first.push_back(count_ + 1);
            for (int side = 0; side < (r_m > 0.0 ? sides_ : 1); ++side)
                addVertex(x_m, r_m, side);
        }
        const auto isRing = [&](std::size_t i) { return outline[i][1] > 0.0; };
        for (std::size_t i = 0; i + 1 < outline.size(); ++i)
            for (int side = 0; side < sides_; ++side) {
                const int a = first[i] + side, b = first[i] + (side + 1) % sides_;
                const int c = first[i + 1] + side, d = first[i + 1] + (side + 1) % sides_;
                if (isRing(i))
                    addFace(a, b, isRing(i + 1) ? d : first[i + 1]);
                if (isRing(i + 1))
                    addFace(isRing(i) ? a : first[i], d, c);
            }
        for (const std::size_t end : {std::size_t{0}, outline.size() - 1})
            for (int side = 1; isRing(end) && side + 1 < sides_; ++side)
                end == 0 ? addFace(first[end], first[end] + side + 1, first[end] + side)
                         : addFace(first[end], first[end] + side, first[end] + side + 1);
    }
    const std::string& text() const { return text_; }

  private:
    void begin(const std::string& material) {
        text_ += "g " + material + "\nusemtl " + material + "\n";
    }
    void addVertex(double x_m, double r_m, int side) {
        const double angle = 2.0 * irsg::pi * side / sides_;
        ++count_;
        text_ += fmt::format("v {:.6f} {:.6f} {:.6f}\n", wider_ * r_m * std::cos(angle),
                             wider_ * r_m * std::sin(angle), x_m);
    }
    void addFace(int a, int b, int c) { text_ += fmt::format("f {} {} {}\n", a, b, c); }

    int sides_, count_ = 0;
    double wider_;
    std::string text_;
};

/// Moves flat ends inwards, at most half of the way to the next ring.
void insetEnds(std::vector<std::array<double, 2>>& outline, double by_m) {
    const std::size_t last = outline.size() - 1;
    if (outline.front()[1] > 0.0)
        outline.front()[0] += std::min(by_m, 0.5 * (outline[1][0] - outline[0][0]));
    if (outline.back()[1] > 0.0)
        outline.back()[0] -= std::min(by_m, 0.5 * (outline[last][0] - outline[last - 1][0]));
}

/// A zone before its shape is written.
struct ZoneGas {
    irsg::GasLayer gas;
    double from_K = 0.0;
};

/// Codes, database and model of zones; `add(object, name, number)` writes the shape of one.
template <typename Add>
void fill(PlumeModel& plume, const PlumeRequest& request, const std::vector<ZoneGas>& zones,
          const Add& add) {
    ObjectText object(request.sides);
    nlohmann::ordered_json rules = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const irsg::GasLayer& gas = zones[i].gas;
        const int index = request.firstIndex + static_cast<int>(i);
        const std::string name = "zone_" + std::to_string(index);
        add(object, name, i);
        rules.push_back(
            {{"material", name}, {"temperatureIndex", index}, {"materialIndex", index}});
        irsg::TemperatureEntry temperature;
        temperature.name = name;
        temperature.terms.base_K = gas.temperature_K;
        temperature.notes = "mean of the plume's nodes from " +
                            irsg::numberText(std::round(zones[i].from_K)) + " K on";
        plume.database.temperatures.emplace(index, std::move(temperature));
        plume.database.materials.emplace(
            index, gasMaterial(gas, name,
                               "mean of the plume's nodes in this zone, weighted with what they "
                               "emit"));
    }
    plume.zones = zones.size();
    plume.database.title = "plume";
    plume.object = object.text();
    const nlohmann::ordered_json codes{{"format", "smat-codes"}, {"version", 1}, {"rules", rules}};
    plume.codes = codes.dump(1) + "\n";
}

/// So many zones as the bound takes: `zonesOf(count)` makes them, `errorsOf(zones)` compares them.
template <typename ZonesOf, typename ErrorsOf>
auto enoughZones(const PlumeRequest& request, const char* otherwise, const ZonesOf& zonesOf,
                 const ErrorsOf& errorsOf) {
    struct Enough {
        decltype(zonesOf(request.fewest)) zones;
        PlumeModel plume;
    };
    Enough best;
    for (std::size_t count = request.fewest; count <= request.most; ++count) {
        Enough found;
        found.zones = zonesOf(count);
        found.plume.errors = errorsOf(found.zones);
        if (best.zones.empty() || found.plume.largestError() < best.plume.largestError())
            best = std::move(found);
        if (best.plume.largestError() <= request.bound)
            break;
    }
    if (!(best.plume.largestError() <= request.bound))
        throw irsg::InputError(
            {"plume", "bound",
             fmt::format("an error of {:.2g} with {} zones, the best of {} to {}",
                         best.plume.largestError(), best.zones.size(), request.fewest,
                         request.most),
             fmt::format("at most {:.2g}: allow more zones or a larger bound; {}", request.bound,
                         otherwise)});
    return best;
}

} // namespace

double PlumeModel::largestError() const {
    double largest = 0.0;
    for (const irsg::PlumeZonesError& error : errors)
        largest = std::max(largest, std::abs(error.relative()));
    return largest;
}

PlumeModel plumeModel(const irsg::PlumeTable& table, const PlumeRequest& request) {
    irsg::plumeZones(table, request.fewest); // what is refused is refused at once
    const irsg::PlumeIntensities intensities(table, request.band);
    auto [zones, plume] = enoughZones(
        request, "gas of one temperature is taken as alike all along the axis",
        [&](std::size_t count) { return irsg::plumeZones(table, count); },
        [&](const auto& of) { return intensities.errorsOf(of); });
    std::vector<ZoneGas> gases;
    for (const irsg::PlumeZone& zone : zones)
        gases.push_back({zone.gas, zone.from_K});
    // Ends of zones at the ends of the table do not lie in one plane. The first zone is all of it.
    const auto& whole = zones.front().outlines_m.front();
    const double apart_m = 1e-5 * (whole.back()[0] - whole.front()[0]);
    fill(plume, request, gases, [&](ObjectText& object, const std::string& name, std::size_t i) {
        for (std::vector<std::array<double, 2>> outline : zones[i].outlines_m) {
            insetEnds(outline, static_cast<double>(i) * apart_m);
            object.add(name, outline);
        }
    });
    return std::move(plume);
}

PlumeModel plumeModel(const irsg::PlumeField& field, const PlumeRequest& request,
                      double elevation_deg) {
    constexpr std::size_t nodesOfWalls = 40000;
    const irsg::GasByTemperature gas(field.parts());
    std::vector<irsg::PlumeView> views = irsg::plumeViews();
    const double cosine = std::cos(irsg::radians(elevation_deg));
    const double sine = std::sin(irsg::radians(elevation_deg));
    for (irsg::PlumeView& view : views) {
        const auto [aft, starboard, up] = view.towards;
        view.towards = {aft * cosine + up * sine, starboard, up * cosine - aft * sine};
    }
    const irsg::FieldIntensities intensities(field,
                                             irsg::FieldWalls(field, gas.coldest_K(), nodesOfWalls),
                                             irsg::PlumeBand(request.band), views);
    auto [zones, plume] = enoughZones(
        request, "gas of one temperature is taken as alike everywhere",
        [&](std::size_t count) { return irsg::fieldZones(gas, count); },
        [&](const auto& of) { return intensities.errorsOf(of); });
    std::vector<ZoneGas> gases;
    for (const irsg::FieldZone& zone : zones)
        gases.push_back({zone.gas, zone.from_K});
    fill(plume, request, gases, [&](ObjectText& object, const std::string& name, std::size_t i) {
        object.add(name, intensities.walls().surfaceFrom(zones[i].from_K), elevation_deg);
    });
    return std::move(plume);
}

std::vector<std::filesystem::path> savePlume(const PlumeModel& plume,
                                             const std::filesystem::path& object) {
    std::filesystem::path codes = object, database = object;
    codes.replace_extension(".codes.json");
    database.replace_extension(".sigdb");
    for (const std::filesystem::path& file : {object, codes, database})
        irsg::checkWritable(file);
    irsg::writeFileDurably(object, plume.object);
    irsg::writeFileDurably(codes, plume.codes);
    irsg::saveSignatureFile(plume.database, database);
    return {object, codes, database};
}

} // namespace smat
