#include "irsg/image/ImageComparison.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/image/CompensatedSum.h"
#include "irsg/image/ImageFile.h"
#include "irsg/image/ImageIntensity.h"
#include "irsg/image/NotANumber.h"
#include "irsg/image/PlaneQuantity.h"

namespace irsg {

namespace {

std::string sizeText(const RadianceImage& image) {
    return std::to_string(image.width()) + " x " + std::to_string(image.height()) + " pixels";
}

std::string attributeOf(const RadianceImage& image, const char* key) {
    const auto found = image.attributes.find(key);
    return found == image.attributes.end() ? "" : found->second;
}

bool isOver(double a, double b, const ComparisonLevel& level) {
    return std::abs(a - b) > level.absolute && std::abs(relativeDifference(a, b)) > level.relative;
}

bool isReached(const ComparisonLevel& level, std::size_t over, std::size_t pixels,
               double largestError) {
    const double letPass = std::max(level.percent / 100.0 * static_cast<double>(pixels),
                                    static_cast<double>(level.allowed));
    return static_cast<double>(over) > letPass || largestError > level.hard;
}

void checkLevel(const ComparisonLevel& level, const std::string& word,
                std::vector<Diagnostic>& diagnostics) {
    const auto check = [&](const std::string& name, double value, bool good,
                           const std::string& expected) {
        if (!good)
            diagnostics.push_back({"", name, numberText(value), expected});
    };
    check(word + " threshold", level.absolute, level.absolute >= 0.0, "a number from 0");
    check(word + " threshold, relative", level.relative,
          level.relative >= 0.0 && level.relative < 2.0, "a number from 0 to less than 2");
    check(word + " percent", level.percent, level.percent >= 0.0 && level.percent < 100.0,
          "a number from 0 to less than 100");
    check("hard " + word + " threshold", level.hard, level.hard >= 0.0, "a number from 0");
}

void count(NonFinite& counted, double value, int x, int y, double a, double b) {
    if (std::isnan(value)) {
        if (counted.nan++ == 0)
            counted.firstNan = {x, y, a, b, notANumber};
    } else if (std::isinf(value)) {
        if (counted.infinite++ == 0)
            counted.firstInfinite = {x, y, a, b, notANumber};
    }
}

/// How a plane is summed: contrast intensity per radiance, or the values as they are.
struct Weights {
    std::optional<PixelSolidAngles> angles;
    double background = 0.0, rangeSquared = 1.0;

    double of(double value, int x, int y) const {
        return angles ? (value - background) * angles->at_sr(x, y) * rangeSquared : value;
    }
};

Weights weightsOf(const RadianceImage& image, const ImageGeometry& geometry) {
    return {PixelSolidAngles(image.width(), image.height(), geometry.horizontalFieldOfView_deg),
            geometry.background_W_m2_sr, geometry.range_m * geometry.range_m};
}

/// One comparison under way.
class Comparing {
  public:
    Comparing(const RadianceImage& a, const RadianceImage& b, const ComparisonOptions& options)
        : Comparing(a, b, options, comparedPlanes(a, b, options)) {}

    Comparison run() {
        result_.area = checkedRectangle(imageA_, options_.rectangle);
        result_.channelA = a_.name;
        result_.channelB = b_.name;
        result_.unit = ofA_.unit.empty() ? ofB_.unit : ofA_.unit;
        result_.quantity = ofA_.name.empty()                             ? ofB_.name
                           : ofB_.name.empty() || ofA_.name == ofB_.name ? ofA_.name
                                                                         : "";
        refuseOtherQuantity();
        warn();
        chooseWeights();
        sumErrors();
        sumRelativeErrors();
        validate();
        return result_;
    }

  private:
    Comparing(const RadianceImage& a, const RadianceImage& b, const ComparisonOptions& options,
              const ComparedPlanes& planes)
        : imageA_(a),
          imageB_(b),
          a_(planes.a),
          b_(planes.b),
          ofA_(quantityOf(a, planes.a)),
          ofB_(quantityOf(b, planes.b)),
          options_(options) {}

    void refuseOtherQuantity() const {
        const bool isAsked =
            !options_.channel.empty() || !options_.channelA.empty() || !options_.channelB.empty();
        if (isAsked || ofA_.name.empty() || ofB_.name.empty() || ofA_.name == ofB_.name)
            return;
        throw InputError({options_.nameB, "", ofB_.name + " (channel " + b_.name + ")",
                          ofA_.name + " as in channel " + a_.name + " of " + options_.nameA +
                              ", or the names of the channels that are compared nevertheless"});
    }

    template <typename Use>
    void forEachPair(Use&& use) const {
        const PixelRectangle& area = result_.area;
        for (int y = area.y; y < area.y + area.height; ++y)
            for (int x = area.x; x < area.x + area.width; ++x) {
                const std::size_t i = imageA_.offset(x, y);
                use(x, y, static_cast<double>(a_.values[i]), static_cast<double>(b_.values[i]));
            }
    }

    void warn() {
        if (!ofA_.unit.empty() && !ofB_.unit.empty() && ofA_.unit != ofB_.unit) {
            result_.warnings.push_back("the units differ: A is in " + ofA_.unit + ", B in " +
                                       ofB_.unit);
            incomparable_ = true;
        }
        const std::string bandA = attributeOf(imageA_, "band.name");
        const std::string bandB = attributeOf(imageB_, "band.name");
        if (!bandA.empty() && !bandB.empty() && bandA != bandB) {
            result_.warnings.push_back("the bands differ: A is " + bandA + ", B is " + bandB);
            incomparable_ = true;
        }
    }

    void chooseWeights() {
        std::optional<ImageGeometry> ofA = geometryOf(imageA_), ofB = geometryOf(imageB_);
        const auto isBand = [](const PlaneQuantity& of) { return of.name == "radiance"; };
        const auto isNothing = [](const PlaneQuantity& of) {
            return of.name.empty() && of.unit.empty();
        };
        const bool radiance = (isBand(ofA_) || isNothing(ofA_)) &&
                              (isBand(ofB_) || isNothing(ofB_)) && (isBand(ofA_) || isBand(ofB_));
        result_.totalIsIntensity = radiance && (ofA || ofB);
        if (!result_.totalIsIntensity) {
            result_.totalUnit = result_.unit.empty() ? "px" : result_.unit + " px";
            return;
        }
        // A plain matrix beside an image of ours is taken as seen by the same camera.
        if (!ofA || !ofB)
            result_.warnings.push_back(std::string("field of view, range and background of ") +
                                       (ofA ? "A are taken for B" : "B are taken for A") +
                                       " as well, which names none");
        result_.totalUnit = "W sr-1";
        weightsA_ = weightsOf(imageA_, ofA ? *ofA : *ofB);
        weightsB_ = weightsOf(imageB_, ofB ? *ofB : *ofA);
    }

    void sumErrors() {
        CompensatedSum errors, absolute, squares, squaresA, squaresB, totalA, totalB;
        double largest = -1.0, largestRelative = -1.0;
        forEachPair([&](int x, int y, double a, double b) {
            ++result_.pixels;
            count(result_.nonFiniteA, a, x, y, a, b);
            count(result_.nonFiniteB, b, x, y, a, b);
            const PixelVerdict verdict = pixelVerdict(a, b, options_);
            result_.overFail += verdict >= PixelVerdict::overFail ? 1 : 0;
            const bool overWarn = verdict == PixelVerdict::notFinite || isOver(a, b, options_.warn);
            result_.overWarn += overWarn ? 1 : 0;
            if (verdict == PixelVerdict::notFinite)
                return;

            ++result_.compared;
            const double error = a - b, relative = relativeDifference(a, b);
            errors.add(error);
            absolute.add(std::abs(error));
            squares.add(error * error);
            squaresA.add(a * a);
            squaresB.add(b * b);
            totalA.add(weightsA_.of(a, x, y));
            totalB.add(weightsB_.of(b, x, y));
            result_.peak = std::max({result_.peak, std::abs(a), std::abs(b)});
            if (std::abs(error) > largest) {
                largest = std::abs(error);
                result_.largest = {x, y, a, b, error};
            }
            if (std::abs(relative) > largestRelative) {
                largestRelative = std::abs(relative);
                result_.largestRelative = {x, y, a, b, relative};
            }
        });

        const auto n = static_cast<double>(result_.compared);
        result_.totalA = totalA.value();
        result_.totalB = totalB.value();
        if (result_.compared == 0) {
            result_.meanError = result_.meanAbsoluteError = result_.rmsError = notANumber;
            result_.peak = result_.peakSignalToNoise_dB = notANumber;
            result_.epsilon = result_.relativeMeanSquareError = notANumber;
            result_.totalA = result_.totalB = notANumber;
            result_.largest.error = result_.largestRelative.error = notANumber;
            return;
        }
        result_.meanError = errors.value() / n;
        result_.meanAbsoluteError = absolute.value() / n;
        result_.rmsError = std::sqrt(squares.value() / n);
        result_.peakSignalToNoise_dB = result_.rmsError == 0.0
                                           ? std::numeric_limits<double>::infinity()
                                           : 20.0 * std::log10(result_.peak / result_.rmsError);
        const double reference = squaresB.value() > 0.0 ? squaresB.value() : squaresA.value();
        result_.epsilon = reference > 0.0 ? 0.01 * reference / n : 1.0;
    }

    void sumRelativeErrors() {
        if (result_.compared == 0)
            return;
        CompensatedSum sum;
        forEachPair([&](int, int, double a, double b) {
            if (std::isfinite(a) && std::isfinite(b))
                sum.add((a - b) * (a - b) / (b * b + result_.epsilon));
        });
        result_.relativeMeanSquareError = sum.value() / static_cast<double>(result_.compared);
    }

    void validate() {
        const double largest = std::abs(result_.largest.error);
        if (result_.compared < result_.pixels ||
            isReached(options_.fail, result_.overFail, result_.pixels, largest))
            result_.verdict = Verdict::failure;
        else if (incomparable_ ||
                 isReached(options_.warn, result_.overWarn, result_.pixels, largest))
            result_.verdict = Verdict::warning;
        else
            result_.verdict = Verdict::pass;
    }

    const RadianceImage &imageA_, &imageB_;
    const ImageChannel &a_, &b_;
    const PlaneQuantity ofA_, ofB_;
    const ComparisonOptions& options_;
    Weights weightsA_, weightsB_;
    Comparison result_;
    bool incomparable_ = false;
};

double percentOf(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace

std::string verdictWord(Verdict verdict) {
    return verdict == Verdict::pass ? "PASS" : verdict == Verdict::warning ? "WARNING" : "FAILURE";
}

void ComparisonOptions::check() const {
    std::vector<Diagnostic> diagnostics;
    checkLevel(fail, "fail", diagnostics);
    checkLevel(warn, "warn", diagnostics);
    if (!diagnostics.empty())
        throw InputError(diagnostics);
}

double Comparison::percentOverFail() const {
    return percentOf(overFail, pixels);
}

double Comparison::percentOverWarn() const {
    return percentOf(overWarn, pixels);
}

Comparison compareImages(const RadianceImage& a, const RadianceImage& b,
                         const ComparisonOptions& options) {
    if (a.width() != b.width() || a.height() != b.height())
        throw InputError(
            {options.nameB, "", sizeText(b), sizeText(a) + ", the size of " + options.nameA});
    options.check();
    return Comparing(a, b, options).run();
}

PixelVerdict pixelVerdict(double a, double b, const ComparisonOptions& options) {
    if (!std::isfinite(a) || !std::isfinite(b))
        return PixelVerdict::notFinite;
    if (isOver(a, b, options.fail))
        return PixelVerdict::overFail;
    return isOver(a, b, options.warn) ? PixelVerdict::overWarn : PixelVerdict::within;
}

double relativeDifference(double a, double b) {
    const double mean = 0.5 * (std::abs(a) + std::abs(b));
    return mean == 0.0 ? 0.0 : (a - b) / mean;
}

double difference(double a, double b, DifferenceMode mode) {
    switch (mode) {
    case DifferenceMode::signedDifference:
        return a - b;
    case DifferenceMode::absolute:
        return std::abs(a - b);
    case DifferenceMode::relative:
        return relativeDifference(a, b);
    case DifferenceMode::ratio:
        return a / b;
    }
    throw LogicError("an unknown kind of difference");
}

ImageChannel differencePlane(const ImageChannel& a, const ImageChannel& b, DifferenceMode mode) {
    if (a.values.size() != b.values.size())
        throw LogicError("planes of different size have no difference");
    static const char* const names[] = {"difference", "absolute_difference", "relative_difference",
                                        "ratio"};
    const bool hasUnit =
        mode == DifferenceMode::signedDifference || mode == DifferenceMode::absolute;
    ImageChannel plane{names[static_cast<int>(mode)],
                       hasUnit ? (a.unit.empty() ? b.unit : a.unit) : std::string(),
                       {}};
    plane.values.resize(a.values.size());
    std::ranges::transform(a.values, b.values, plane.values.begin(), [mode](float x, float y) {
        return static_cast<float>(difference(static_cast<double>(x), static_cast<double>(y), mode));
    });
    return plane;
}

} // namespace irsg
