#include "irsg/image/PngView.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/core/Quantity.h"
#include "irsg/image/ApparentTemperature.h"
#include "irsg/image/AxisTicks.h"
#include "irsg/image/ImageFormat.h"
#include "irsg/image/PictureFont.h"

namespace irsg {

namespace {

constexpr Rgb paper{255, 255, 255}, ink{38, 38, 38}, line = viewFrameColor;
constexpr int comfortableHeight_px = 240;
/// Of text at scale 1, px: as plots have it at 96 dots an inch.
constexpr double titleSize_px = 13.0, conditionsSize_px = 11.0, barSize_px = 11.0;
constexpr int largestSide_px = 65535;

/// Values of a plane that the map has no place for.
struct OutOfRange {
    std::size_t below = 0, above = 0, notANumber = 0;
};

OutOfRange countOutOfRange(const ImageChannel& plane, const DisplayLimits& limits) {
    OutOfRange count;
    for (const float value : plane.values) {
        count.below += value < limits.low ? 1 : 0;
        count.above += value > limits.high ? 1 : 0;
        count.notANumber += std::isnan(value) ? 1 : 0;
    }
    return count;
}

DisplayLimits chosenLimits(const ImageChannel& plane, const PngViewOptions& options,
                           const ColorMap& map) {
    if (!options.limits)
        return map.isDiverging() ? symmetricLimits(plane.values) : percentileLimits(plane.values);
    const DisplayLimits& limits = *options.limits;
    if (!(limits.low < limits.high) || !std::isfinite(limits.low) || !std::isfinite(limits.high))
        throw InputError({"", "display limits",
                          numberText(limits.low) + " to " + numberText(limits.high),
                          "two finite numbers, the lower one first"});
    return limits;
}

std::string quantityLabel(const ImageChannel& plane) {
    if (plane.name == "L")
        return std::string(info(Quantity::radiance).label);
    if (plane.name == apparentTemperatureChannel)
        return std::string(info(Quantity::apparentTemperature).label);
    std::string words = plane.name;
    std::ranges::replace(words, '_', ' ');
    return words;
}

std::string barLabel(const ImageChannel& plane, const PngViewOptions& options, int exponent) {
    const std::string power = exponent == 0 ? "" : "×10" + superscript(exponent);
    std::string unit = prettyUnit(plane.unit);
    if (!power.empty())
        unit = unit.empty() ? power : power + " " + unit;
    const std::string name = options.label.empty() ? quantityLabel(plane) : options.label;
    return unit.empty() ? name : name + " (" + unit + ")";
}

void drawPlane(Canvas& canvas, int left, int top, int magnification, const RadianceImage& image,
               const ImageChannel& plane, const ColorMap& map, const DisplayLimits& limits) {
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            canvas.fill(left + x * magnification, top + y * magnification, magnification,
                        magnification, map.color(plane.values[image.offset(x, y)], limits));
}

/// The colour bar with what belongs to it: measured first, drawn when the canvas is there.
class ColorBar {
  public:
    ColorBar(const ColorMap& map, const DisplayLimits& limits, const OutOfRange& outOfRange,
             int height, int scale, const PictureFont& font)
        : map_(map), limits_(limits), scale_(scale), font_(font) {
        // Swatches of what is out of range above and below the bar.
        if (outOfRange.above > 0)
            addSwatch(map.above(), "above", outOfRange.above, true);
        if (outOfRange.below > 0)
            addSwatch(map.below(), "below", outOfRange.below, false);
        if (outOfRange.notANumber > 0)
            addSwatch(map.notANumber(), "NaN", outOfRange.notANumber, false);
        top_ = outOfRange.above > 0 ? swatchPitch() : 0;
        int below = 0;
        for (Swatch& swatch : swatches_)
            if (!swatch.isAbove)
                below += swatchPitch();
        bottom_ = std::max(height - below, top_ + 4 * swatchPitch());
        int next = bottom_ + swatchPitch() - swatchHeight();
        for (Swatch& swatch : swatches_) {
            swatch.top = swatch.isAbove ? 0 : next;
            next += swatch.isAbove ? 0 : swatchPitch();
        }
        ticks_ = axisTicks(limits, std::max(2, (bottom_ - top_) / (30 * scale)));
    }

    int exponent() const { return ticks_.exponent; }
    int height() const {
        return swatches_.empty() || swatches_.back().isAbove
                   ? bottom_
                   : swatches_.back().top + swatchHeight();
    }
    int width() const {
        int widest = 0;
        for (const std::string& label : ticks_.labels)
            widest = std::max(widest, font_.width(label));
        for (const Swatch& swatch : swatches_)
            widest = std::max(widest, font_.width(swatch.label));
        return labelOffset() + widest;
    }

    void draw(Canvas& canvas, int left, int top) const {
        for (int row = top_; row < bottom_; ++row) {
            const double t = 1.0 - (row - top_ + 0.5) / (bottom_ - top_);
            canvas.fill(left, top + row, barWidth(), 1, map_.at(t));
        }
        canvas.frame(left, top + top_, barWidth(), bottom_ - top_, scale_, line);

        for (std::size_t i = 0; i < ticks_.values.size(); ++i) {
            const double t = limits_.position(ticks_.values[i]);
            const int y = top + bottom_ - static_cast<int>(std::lround(t * (bottom_ - top_)));
            canvas.fill(left + barWidth() + scale_, y - scale_ / 2, tickLength(), scale_, line);
            font_.draw(canvas, left + labelOffset(), y + (font_.capHeight() + scale_) / 2,
                       ticks_.labels[i], ink);
        }
        for (const Swatch& swatch : swatches_) {
            const int y = top + swatch.top;
            canvas.fill(left, y, barWidth(), swatchHeight(), swatch.color);
            canvas.frame(left, y, barWidth(), swatchHeight(), scale_, line);
            font_.draw(canvas, left + labelOffset(), y + (swatchHeight() + font_.capHeight()) / 2,
                       swatch.label, ink);
        }
    }

  private:
    struct Swatch {
        Rgb color;
        std::string label;
        bool isAbove;
        int top = 0;
    };

    void addSwatch(Rgb color, const std::string& name, std::size_t count, bool isAbove) {
        swatches_.push_back({color, name + ": " + std::to_string(count) + " px", isAbove});
    }
    int barWidth() const { return 18 * scale_; }
    int tickLength() const { return 5 * scale_; }
    int labelOffset() const { return barWidth() + tickLength() + 6 * scale_; }
    int swatchHeight() const { return 12 * scale_; }
    int swatchPitch() const { return 24 * scale_; }

    const ColorMap& map_;
    DisplayLimits limits_;
    int scale_;
    const PictureFont& font_;
    int top_ = 0, bottom_ = 0; // of the gradient, from the top of the whole
    AxisTicks ticks_;
    std::vector<Swatch> swatches_;
};

void checkSize(std::int64_t width, std::int64_t height) {
    if (width > largestSide_px || height > largestSide_px)
        throw InputError({"", "picture",
                          std::to_string(width) + " x " + std::to_string(height) + " pixels",
                          "at most " + std::to_string(largestSide_px) + " a side"});
}

void checkOptions(const PngViewOptions& options) {
    const auto check = [](const std::string& name, int value, int most) {
        if (value < 0 || value > most)
            throw InputError({"", name, std::to_string(value), "0 to " + std::to_string(most)});
    };
    check("magnification", options.magnification, 64);
    check("text scale", options.textScale, 8);
}

} // namespace

Canvas renderView(const RadianceImage& image, const ImageChannel& plane,
                  const PngViewOptions& options) {
    if (plane.values.size() != image.pixelCount() || image.empty())
        throw LogicError("channel " + plane.name + " is not as large as its image");
    checkOptions(options);
    const ColorMap& map = ColorMap::named(options.colorMap);
    const DisplayLimits limits = chosenLimits(plane, options, map);

    // The size of the plane in the view.
    int magnification = std::max(options.magnification, 1);
    if (options.magnification == 0 && options.colorBar)
        magnification =
            std::max(1, std::min((comfortableHeight_px + image.height() - 1) / image.height(),
                                 6 * comfortableHeight_px / image.width()));
    checkSize(std::int64_t{image.width()} * magnification,
              std::int64_t{image.height()} * magnification);
    const int width = image.width() * magnification, height = image.height() * magnification;
    if (!options.colorBar) {
        Canvas canvas(width, height);
        drawPlane(canvas, 0, 0, magnification, image, plane, map, limits);
        return canvas;
    }

    // Title, then the label of the bar, then plane and bar side by side.
    const int scale = options.textScale > 0            ? options.textScale
                      : std::max(width, height) > 1400 ? 2
                                                       : 1;
    OutOfRange outOfRange = countOutOfRange(plane, limits);
    if (!limits.marksOutside)
        outOfRange.below = outOfRange.above = 0;
    const PictureFont titleFont(FontWeight::bold, titleSize_px * scale);
    const PictureFont conditionsFont(FontWeight::regular, conditionsSize_px * scale);
    const PictureFont barFont(FontWeight::regular, barSize_px * scale);
    const ColorBar bar(map, limits, outOfRange, std::max(height, 160 * scale), scale, barFont);
    const std::string label = barLabel(plane, options, bar.exponent());
    const int margin = 16 * scale, lineHeight = 22 * scale;
    const int titleHeight = options.title.empty() ? 0 : lineHeight;
    const int conditionsHeight = options.conditions.empty() ? 0 : lineHeight;
    const int top = margin + titleHeight + conditionsHeight + lineHeight;
    const int barLeft = margin + width + 20 * scale;
    const std::int64_t right =
        std::max<std::int64_t>({barLeft + bar.width(), std::int64_t{barLeft} + barFont.width(label),
                                std::int64_t{margin} + titleFont.width(options.title),
                                std::int64_t{margin} + conditionsFont.width(options.conditions)});
    const int bottom = top + std::max(height, bar.height());
    checkSize(right + margin, bottom + margin);

    Canvas canvas(static_cast<int>(right) + margin, bottom + margin, paper);
    int baseline = margin + 10 * scale;
    titleFont.draw(canvas, margin, baseline, options.title, ink);
    baseline += titleHeight;
    conditionsFont.draw(canvas, margin, baseline, options.conditions, line);
    baseline += conditionsHeight;
    barFont.draw(canvas, barLeft, baseline, label, ink);
    drawPlane(canvas, margin, top, magnification, image, plane, map, limits);
    canvas.frame(margin, top, width, height, scale, line);
    bar.draw(canvas, barLeft, top);
    return canvas;
}

void writePngView(const RadianceImage& image, const std::filesystem::path& file,
                  const PngViewOptions& options, const std::string& channel) {
    const ImageChannel* plane = channel.empty() ? &image.primary() : image.find(channel);
    if (plane == nullptr)
        throw LogicError("an image has no channel " + channel);
    writePng(renderView(image, *plane, options), file);
}

extern constinit const ImageFormat pngFormat{
    .name = "Picture",
    .shortName = "PNG",
    .extensions = ".png",
    .keeps = ImageFormat::Keeps::picture,
    .isUsual = true,
    .write = [](const RadianceImage& image, const std::filesystem::path& file,
                const ImageWriting& how) { writePngView(image, file, how.view, how.channel); }};

} // namespace irsg
