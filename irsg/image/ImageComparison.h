#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "irsg/image/ImageStatistics.h"
#include "irsg/image/RadianceImage.h"

namespace irsg {

/// The thresholds of a failure, or of a warning, with the meaning they have in OpenImageIO's idiff.
struct ComparisonLevel {
    /// A pixel is over the level where |A - B| is larger than `absolute` (unit of the images) and
    /// |A - B| / ((|A| + |B|) / 2) is larger than `relative` (0 to 2).
    double absolute = 1e-6;
    double relative = 0.0;
    /// The level is reached where more pixels are over it than either of these lets pass: percent
    /// of the pixels (0 to less than 100), or their number.
    double percent = 0.0;
    std::size_t allowed = 0;
    /// ... or where one |A - B| is larger than this.
    double hard = std::numeric_limits<double>::infinity();

    bool operator==(const ComparisonLevel&) const = default;
};

enum class Verdict { pass, warning, failure };
/// "PASS", "WARNING", "FAILURE".
std::string verdictWord(Verdict verdict);

struct ComparisonOptions {
    ComparisonLevel fail{}, warn{};
    std::string channel{}; ///< of both images; empty: see chosenPlane
    /// Of one image each, before `channel`.
    std::string channelA{}, channelB{};
    std::optional<PixelRectangle> rectangle{};        ///< compares this part alone
    std::string nameA = "image A", nameB = "image B"; ///< for messages

    /// Throws InputError that names every threshold out of its range or not a number.
    void check() const;
};

/// A pixel with both of its values.
struct PixelPair {
    int x = -1, y = -1; ///< -1: there is none
    double a = 0.0, b = 0.0;
    double error = 0.0; ///< A - B, or the relative difference with its sign
};

/// Pixels of an image that hold no finite value, and the first of each kind in reading order.
struct NonFinite {
    std::size_t nan = 0, infinite = 0;
    PixelPair firstNan, firstInfinite;
};

/// What is said of two images, all of it together. Figures are those of the pixels where both are
/// finite, sums in double; without such a pixel they are NaN. A pixel without a finite value in
/// either image is over both levels, and no allowance lets it pass: the verdict is a failure.
/// Units or bands that differ make it a warning at least.
struct Comparison {
    PixelRectangle area;
    std::string channelA, channelB;
    std::string quantity; ///< of both, as in PlaneQuantity; "" where it is not known or differs
    std::string unit;
    std::size_t pixels = 0, compared = 0; ///< of the area; those where both are finite

    double meanError = 0.0;         ///< mean of A - B
    double meanAbsoluteError = 0.0; ///< mean of |A - B|
    double rmsError = 0.0;
    double peak = 0.0;                    ///< largest |A| or |B|
    double peakSignalToNoise_dB = 0.0;    ///< 20 lg(peak / RMSE), infinite for equal images
    double epsilon = 0.0;                 ///< 0.01 of the mean of B^2; of A^2 where B is 0; else 1
    double relativeMeanSquareError = 0.0; ///< mean of (A - B)^2 / (B^2 + epsilon)
    PixelPair largest;                    ///< by |A - B|
    PixelPair largestRelative;            ///< by |A - B| / ((|A| + |B|) / 2), 0 where both are 0

    std::size_t overFail = 0, overWarn = 0; ///< pixels, those without a value among them
    NonFinite nonFiniteA, nonFiniteB;

    /// Contrast intensity, W sr-1 (sum of (L - L_bg) omega R^2), where the images are radiance and
    /// their geometry is known; otherwise the sum of the values, unit times pixels.
    double totalA = 0.0, totalB = 0.0;
    bool totalIsIntensity = false;
    std::string totalUnit;

    std::vector<std::string> warnings; ///< units and bands that differ, geometry that was borrowed
    Verdict verdict = Verdict::failure;

    double percentOverFail() const;
    double percentOverWarn() const;
};

/// Compares A with B, B being the reference. Throws InputError for images of different size before
/// anything else, for a channel that is not there, thresholds and rectangles that cannot be used,
/// and for planes of two quantities that are known (PlaneQuantity.h), unless a channel was named.
Comparison compareImages(const RadianceImage& a, const RadianceImage& b,
                         const ComparisonOptions& options = {});

/// Where a pair of values stands.
enum class PixelVerdict { within, overWarn, overFail, notFinite };
PixelVerdict pixelVerdict(double a, double b, const ComparisonOptions& options);

/// |A - B| / ((|A| + |B|) / 2), with the sign of A - B; 0 where both are 0.
double relativeDifference(double a, double b);

/// What a picture of the difference shows.
enum class DifferenceMode { signedDifference, absolute, relative, ratio };
inline constexpr DifferenceMode allDifferenceModes[] = {
    DifferenceMode::signedDifference, DifferenceMode::absolute, DifferenceMode::relative,
    DifferenceMode::ratio};

/// A - B, |A - B|, (A - B) / ((|A| + |B|) / 2) or A / B; NaN where that is no number.
double difference(double a, double b, DifferenceMode mode);
/// The plane of it, with its unit, called "difference", "absolute_difference",
/// "relative_difference" or "ratio". LogicError for planes of different size.
ImageChannel differencePlane(const ImageChannel& a, const ImageChannel& b, DifferenceMode mode);

} // namespace irsg
