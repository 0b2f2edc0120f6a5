#include "smatcore/analysis/PixelText.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace smat {

namespace {

using irsg::ExplainedSurface;
using irsg::ExplainedTerm;
using irsg::PixelExplanation;
using OrderedJson = nlohmann::ordered_json;

std::string line(const std::string& what, double value, const char* unit = "W m-2 sr-1") {
    return fmt::format("  {:<34} {:>16.9g}  {}\n", what, value, unit);
}

std::string codeText(int index, const std::string& name) {
    return name.empty() ? std::to_string(index) : fmt::format("{} {}", index, name);
}

std::string surfaceText(const ExplainedSurface& surface) {
    std::string text = fmt::format("\nlayer {}: {}{}\n", surface.layer, surface.object,
                                   surface.lightAlone ? ", light that it gets through others" : "");
    text += fmt::format("  {:<34} {}\n", "temperature index",
                        codeText(surface.temperatureIndex, surface.temperatureName));
    if (surface.measuredSpectrum.empty())
        text += line("temperature", surface.temperature_K, "K");
    else
        text += fmt::format("  {:<34} {}\n", "measured spectrum", surface.measuredSpectrum);
    text += fmt::format("  {:<34} {}\n", "material index",
                        codeText(surface.materialIndex, surface.materialName));
    text += line("emissivity in the band", surface.emissivity, "");
    text += line("reflectivity in the band", surface.reflectivity, "");
    text += line("transmissivity in the band", surface.transmissivity, "");
    if (surface.nAngleFactor != 0.0)
        text += line("N of cos^N", surface.nAngleFactor, "");
    if (!surface.lightAlone) {
        text += line("share of the pixel", surface.share, "");
        text += line("range", surface.range_m, "m");
    }
    text += line("transmittance of the air", surface.atmosphereTransmittance, "");
    if (!surface.throughMaterials.empty()) {
        text += fmt::format("  {:<34} {}\n", "seen or lit through",
                            fmt::join(surface.throughMaterials, "; "));
        text += line("transmittance of these", surface.throughTransmittance, "");
    }
    text += fmt::format("  {:<10} {:>12} {:>16} {:>18} {:>18}\n", "term", "factor", "light",
                        "at factor 1", "in the pixel");
    for (const ExplainedTerm& term : surface.terms)
        text += fmt::format("  {:<10} {:>12.7g} {:>16} {:>18.9g} {:>18.9g}\n", term.name,
                            term.factor, term.light ? fmt::format("{:.7g}", *term.light) : "-",
                            term.atFactorOne_W_m2_sr, term.radiance_W_m2_sr);
    if (surface.betweenSurfaces_W_m2_sr != 0.0)
        text += line("light of other surfaces", surface.betweenSurfaces_W_m2_sr);
    text += line("all that it sends", surface.radiance_W_m2_sr);
    if (!surface.lightAlone)
        text += line("background that it hides", surface.hidden_W_m2_sr);
    return text;
}

std::string pixelText(const ExplainedPixel& pixel) {
    const PixelExplanation& of = pixel.computed;
    std::string text = fmt::format("pixel {},{} (0,0 is the top left)\n", of.x, of.y);
    for (const ExplainedSurface& surface : of.surfaces)
        text += surfaceText(surface);
    text += of.surfaces.empty() ? "\nbackground alone\n" : "\nbackground\n";
    const auto part = [&](const char* what, const std::optional<double>& value) {
        if (value)
            text += line(what, *value);
    };
    part("sky pictures and the sun's disc", of.sky_W_m2_sr);
    part("terrain", of.terrain_W_m2_sr);
    part("the environment's", of.environment_W_m2_sr);
    text += line("behind the pixel", of.background_W_m2_sr);
    text += line("of it arrives", of.backgroundLeft_W_m2_sr);
    text += "\nsum\n";
    text += line("computed", of.radiance_W_m2_sr);
    text += line("rendered", pixel.drawn_W_m2_sr);
    text += line("difference", pixel.difference_W_m2_sr());
    text += line("relative difference", pixel.relative(), "");
    if (pixel.inImage_W_m2_sr) {
        text += line("in the image", *pixel.inImage_W_m2_sr);
        text += line("rendered now, minus image", pixel.drawn_W_m2_sr - *pixel.inImage_W_m2_sr);
    }
    text += fmt::format("  {:<34} {:>16}\n", "rays through the pixel", of.samples);
    text += fmt::format("  {:<34} {:>16}\n", "3 x 3 pixels hit the same facet",
                        of.isInterior ? "yes" : "no");
    if (!of.isInterior && of.samples > 0)
        text += "  Where edges cross the pixel, a ray and the rendered sample may be on different "
                "sides of an edge.\n";
    if (of.layersLeftOver > 0)
        text += fmt::format("  {:<34} {:>16}\n", "rays with layers left out", of.layersLeftOver);
    for (const std::string& remark : of.remarks)
        text += "  " + remark + "\n";
    return text;
}

OrderedJson surfaceJson(const ExplainedSurface& surface) {
    OrderedJson terms = OrderedJson::array();
    for (const ExplainedTerm& term : surface.terms)
        terms.push_back({{"name", term.name},
                         {"factor", term.factor},
                         {"light", term.light ? OrderedJson(*term.light) : OrderedJson()},
                         {"at_factor_1_W_m2_sr", term.atFactorOne_W_m2_sr},
                         {"radiance_W_m2_sr", term.radiance_W_m2_sr}});
    const bool isMeasured = !surface.measuredSpectrum.empty();
    return {
        {"layer", surface.layer},
        {"light_alone", surface.lightAlone},
        {"object", surface.object},
        {"temperature_index", surface.temperatureIndex},
        {"temperature_name", surface.temperatureName},
        {"temperature_K", isMeasured ? OrderedJson() : OrderedJson(surface.temperature_K)},
        {"measured_spectrum", isMeasured ? OrderedJson(surface.measuredSpectrum) : OrderedJson()},
        {"material_index", surface.materialIndex},
        {"material_name", surface.materialName},
        {"emissivity", surface.emissivity},
        {"reflectivity", surface.reflectivity},
        {"transmissivity", surface.transmissivity},
        {"n_angle_factor", surface.nAngleFactor},
        {"share", surface.share},
        {"range_m", surface.range_m},
        {"air_transmittance", surface.atmosphereTransmittance},
        {"through", surface.throughMaterials},
        {"through_transmittance", surface.throughTransmittance},
        {"terms", terms},
        {"between_surfaces_W_m2_sr", surface.betweenSurfaces_W_m2_sr},
        {"radiance_W_m2_sr", surface.radiance_W_m2_sr},
        {"hidden_background_W_m2_sr", surface.hidden_W_m2_sr}};
}

OrderedJson pixelJson(const ExplainedPixel& pixel) {
    const PixelExplanation& of = pixel.computed;
    OrderedJson surfaces = OrderedJson::array();
    for (const ExplainedSurface& surface : of.surfaces)
        surfaces.push_back(surfaceJson(surface));
    const auto part = [](const std::optional<double>& value) {
        return value ? OrderedJson(*value) : OrderedJson();
    };
    return {{"x", of.x},
            {"y", of.y},
            {"surfaces", surfaces},
            {"background",
             {{"sky_W_m2_sr", part(of.sky_W_m2_sr)},
              {"terrain_W_m2_sr", part(of.terrain_W_m2_sr)},
              {"environment_W_m2_sr", part(of.environment_W_m2_sr)},
              {"behind_W_m2_sr", of.background_W_m2_sr},
              {"arrives_W_m2_sr", of.backgroundLeft_W_m2_sr}}},
            {"computed_W_m2_sr", of.radiance_W_m2_sr},
            {"drawn_W_m2_sr", pixel.drawn_W_m2_sr},
            {"difference_W_m2_sr", pixel.difference_W_m2_sr()},
            {"relative_difference", pixel.relative()},
            {"in_image_W_m2_sr", part(pixel.inImage_W_m2_sr)},
            {"rays", of.samples},
            {"same_facet_3x3", of.isInterior},
            {"rays_with_layers_left_out", of.layersLeftOver},
            {"remarks", of.remarks}};
}

} // namespace

double ExplainedPixel::relative() const {
    const double difference = difference_W_m2_sr();
    return difference == 0.0 ? 0.0 : difference / std::abs(drawn_W_m2_sr);
}

std::string explanationText(const std::vector<ExplainedPixel>& pixels,
                            const std::string& renderer) {
    std::string text = "drawn by " + renderer + "\n";
    for (const ExplainedPixel& pixel : pixels)
        text += "\n" + pixelText(pixel);
    return text;
}

std::string explanationJson(const std::vector<ExplainedPixel>& pixels,
                            const std::string& renderer) {
    OrderedJson list = OrderedJson::array();
    for (const ExplainedPixel& pixel : pixels)
        list.push_back(pixelJson(pixel));
    return OrderedJson{{"renderer", renderer}, {"pixels", list}}.dump(
               1, ' ', false, OrderedJson::error_handler_t::replace) +
           "\n";
}

} // namespace smat
