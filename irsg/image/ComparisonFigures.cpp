#include "irsg/image/ComparisonFigures.h"

#include <array>
#include <charconv>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/image/ImageFile.h"

namespace irsg {

namespace {

std::string place(const PixelPair& pair) {
    return "at (" + std::to_string(pair.x) + ", " + std::to_string(pair.y) + ")";
}

std::string pairText(const PixelPair& pair) {
    return pair.x < 0 ? ""
                      : place(pair) + ", A " + shortNumber(pair.a) + ", B " + shortNumber(pair.b);
}

std::string thresholdText(const ComparisonLevel& level, const std::string& unit) {
    std::string text = "over " + shortNumber(level.absolute) + (unit.empty() ? "" : " " + unit);
    if (level.relative > 0.0)
        text += " and over " + shortNumber(level.relative) + " relative";
    if (level.percent > 0.0)
        text += ", " + shortNumber(level.percent) + " % allowed";
    if (level.allowed > 0)
        text += ", " + std::to_string(level.allowed) + " allowed";
    if (std::isfinite(level.hard))
        text += ", never above " + shortNumber(level.hard);
    return text;
}

std::string firstText(const PixelPair& first) {
    return first.x < 0 ? "" : "the first " + place(first);
}

double asNumber(std::size_t count) {
    return static_cast<double>(count);
}

} // namespace

std::string shortNumber(double value) {
    if (std::isnan(value))
        return "nan";
    std::array<char, 32> text;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6)
            .ptr;
    return {text.data(), end};
}

std::vector<ComparisonFigure> comparisonFigures(const Comparison& c,
                                                const ComparisonOptions& options) {
    const std::string& unit = c.unit;
    std::vector<ComparisonFigure> figures = {
        {"mean_error", "Mean error, A - B", c.meanError, unit, ""},
        {"mean_absolute_error", "Mean absolute error", c.meanAbsoluteError, unit, ""},
        {"rms_error", "RMS error", c.rmsError, unit, ""},
        {"psnr", "PSNR", c.peakSignalToNoise_dB, "dB", "peak " + shortNumber(c.peak)},
        {"rel_mse", "relMSE", c.relativeMeanSquareError, "", "epsilon " + shortNumber(c.epsilon)},
        {"max_error", "Largest error, A - B", c.largest.error, unit, pairText(c.largest)},
        {"max_relative_error", "Largest relative error", c.largestRelative.error, "",
         pairText(c.largestRelative)},
        {"pixels", "Pixels compared", asNumber(c.compared), "px", "of " + std::to_string(c.pixels)},
        {"fail_pixels", "Pixels over the fail threshold", asNumber(c.overFail), "px",
         thresholdText(options.fail, unit)},
        {"fail_percent", "", c.percentOverFail(), "%", ""},
        {"warn_pixels", "Pixels over the warn threshold", asNumber(c.overWarn), "px",
         thresholdText(options.warn, unit)},
        {"warn_percent", "", c.percentOverWarn(), "%", ""},
        {"nan_a", "NaN in A", asNumber(c.nonFiniteA.nan), "px", firstText(c.nonFiniteA.firstNan)},
        {"nan_b", "NaN in B", asNumber(c.nonFiniteB.nan), "px", firstText(c.nonFiniteB.firstNan)},
        {"infinite_a", "Infinite in A", asNumber(c.nonFiniteA.infinite), "px",
         firstText(c.nonFiniteA.firstInfinite)},
        {"infinite_b", "Infinite in B", asNumber(c.nonFiniteB.infinite), "px",
         firstText(c.nonFiniteB.firstInfinite)}};
    const std::string total = c.totalIsIntensity ? "Contrast intensity" : "Sum of the values";
    const std::string key = c.totalIsIntensity ? "contrast_intensity" : "sum";
    figures.push_back({key + "_a", total + " of A", c.totalA, c.totalUnit, ""});
    figures.push_back({key + "_b", total + " of B", c.totalB, c.totalUnit, ""});
    figures.push_back(
        {key + "_difference", total + ", A - B", c.totalA - c.totalB, c.totalUnit,
         c.totalB == 0.0 || !std::isfinite(c.totalB)
             ? ""
             : shortNumber(100.0 * (c.totalA - c.totalB) / std::abs(c.totalB)) + " % of B"});
    return figures;
}

RadianceImage differenceImage(const RadianceImage& a, const RadianceImage& b,
                              const Comparison& comparison, const ComparisonOptions& options,
                              DifferenceMode mode) {
    const auto& [planeA, planeB] = comparedPlanes(a, b, options);
    ImageChannel plane = differencePlane(planeA, planeB, mode);
    if (mode == DifferenceMode::signedDifference || mode == DifferenceMode::absolute)
        plane.unit = comparison.unit; // which attributes may state
    RadianceImage image(a.width(), a.height(), plane.name, plane.unit);
    image.primary().values = std::move(plane.values);
    image.channel("A", planeA.unit).values = planeA.values;
    image.channel("B", planeB.unit).values = planeB.values;

    image.attributes["compare.A"] = options.nameA + ", channel " + planeA.name;
    image.attributes["compare.B"] = options.nameB + ", channel " + planeB.name;
    if (!comparison.quantity.empty())
        image.attributes["compare.quantity"] = comparison.quantity;
    image.attributes["compare.verdict"] = verdictWord(comparison.verdict);
    for (const ComparisonFigure& figure : comparisonFigures(comparison, options))
        image.attributes["compare." + figure.key] =
            numberText(figure.value) + (figure.unit.empty() ? "" : " " + figure.unit);
    return image;
}

} // namespace irsg
