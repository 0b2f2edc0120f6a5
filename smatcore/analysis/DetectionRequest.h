#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "irsg/sensor/DetectionRange.h"
#include "irsg/sensor/ResolvableTemperature.h"
#include "irsg/sensor/SensorDescription.h"
#include "irsg/sensor/TargetingTask.h"
#include "smatcore/project/AnalysisKind.h"

namespace smat {

/// Where in a pixel the image of the target lies.
enum class PointPlace {
    centre, ///< in the middle: the most ensquared energy
    mean,   ///< anywhere: its mean over a pixel
    corner  ///< where four pixels meet: the least
};

/// What it means that a sensor sees the target.
enum class RangeCriterion {
    point,    ///< signal to noise of its whole light in one pixel
    bars,     ///< Johnson: its mean contrast resolves as many cycles across it as a task needs
    targeting ///< the same with the cycles of the TTP metric
};

/// Which cases a range is sought for.
enum class RangeCases {
    aspects,   ///< those of a polar plot
    directions ///< those of a signature table: azimuth and elevation
};

/// What ranges are compared over.
enum class RangeAgainst {
    wind,       ///< m/s, of a computed atmosphere with Navy maritime or desert aerosol
    visibility, ///< m, of a computed atmosphere
    humidity,   ///< %, of a computed atmosphere that follows measurements
    hour,       ///< of the day, local solar time
    band,       ///< of the sensor, um, within its spectra
    paint       ///< of the target
};

/// The values that ranges are compared over.
struct RangeComparison {
    RangeAgainst against = RangeAgainst::wind;
    /// Numbers; of bands "3.7-4.2"; of paints emissivities, or names of materials of the target's
    /// database or of the library.
    std::vector<std::string> values;
    std::string paint; ///< the material of the target that another takes the place of
    /// Of hours: where the sun goes its way; none: it stays.
    struct Place {
        std::string date; ///< "2025-06-21"
        double latitude_deg = 0.0, longitude_deg = 0.0;
    };
    std::optional<Place> place;
};

/// "2025-06-21, 54.3, 10.1": a day, latitude and longitude in deg. Throws InputError that names
/// `what`.
RangeComparison::Place rangePlaceOf(const std::string& what, const std::string& text);

/// A task of a criterion of cycles.
struct RangeTask {
    double cyclesOfHalf = 0.75; ///< for a probability of 50 %; > 0
    double probability = 0.5;   ///< 0 to 1, both exclusive
};

/// How far a sensor sees the target: an analysis of the cases of a polar plot or a signature table,
/// in which the range of each is sought.
struct DetectionRequest {
    irsg::SensorDescription sensor;
    std::filesystem::path sensorFile; ///< that it is from; for provenance and command
    RangeCriterion criterion = RangeCriterion::point;
    double threshold = 5.0; ///< of points: signal to noise ratio, > 0
    /// Of points: that the ratio with its noise is above the threshold, the mean over all places
    /// of the image in its pixel, 0 to 1, both exclusive; none: the ratio without noise is.
    std::optional<double> pointProbability;
    /// Of points: the standard deviation of the background from pixel to pixel, as that of its
    /// apparent temperature, which is noise as well.
    double clutter_K = 0.0;
    /// Of points: the same of the background's own pixels about the target, at the range of each
    /// case (BackgroundClutter), in place of a number.
    bool measuresClutter = false;
    /// Adds how sensitive the range is to each number of sensor, air and signature.
    bool findsSensitivity = false;
    RangeCases cases = RangeCases::aspects;
    /// In place of a row for each case one for each of these values, of all cases.
    std::optional<RangeComparison> comparison;
    /// Where the probability is looked at, m, > 0, in place of the search of a range; empty: the
    /// range is sought.
    std::vector<double> ranges_m;
    /// Of a probability over range: draws of the scaling files beside the models; 0: none.
    std::size_t draws = 0;
    RangeTask task; ///< of cycles
    /// Of cycles: temperatures and materials, by the names of partsOf, whose surfaces are not
    /// counted: hot parts and plumes, which raise the mean contrast though nobody resolves them.
    std::vector<std::string> leftOut;
    irsg::Observer observer;
    irsg::SensorDisplay display; ///< of the TTP metric
    irsg::RangeLimits limits{.nearest_m = 100.0, .farthest_m = 1e6, .looksPerDecade = 4};
    PointPlace place = PointPlace::centre;
    /// Of the noise; none: that of the scene behind the target, at each range.
    std::optional<double> background_K;

    /// Whether a point has a probability.
    bool needsProbability() const { return pointProbability || !ranges_m.empty(); }
};

/// The kind of its results.
AnalysisKind detectionKind();
/// The analysis that has such cases.
AnalysisKind kindOf(RangeCases cases);

/// Words of places and tasks, as commands have them.
const std::vector<std::string>& pointPlaceWords();   ///< "centre", ... by PointPlace
const std::vector<std::string>& criterionWords();    ///< "point", "johnson", "ttp"
const std::vector<std::string>& rangeCasesWords();   ///< "aspects", "directions"
const std::vector<std::string>& rangeAgainstWords(); ///< "wind", "visibility", ...
std::vector<std::string> rangeTaskWords();           ///< "detection", ... of every criterion
/// The tasks of a criterion of cycles, and its law of probability.
const std::vector<irsg::JohnsonTask>& tasksOf(RangeCriterion criterion);
const irsg::TaskLaw& lawOf(RangeCriterion criterion);

/// The threshold, in deviations of normal noise, that it passes by itself with this probability in
/// a pixel and a frame, 0 to 0.5, both exclusive (InputError).
double thresholdOfFalseAlarms(double probability);

} // namespace smat
