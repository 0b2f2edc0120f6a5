#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/scene/InteractiveRenderer.h"

/// The study of antialiasing: errors and times for every mode of the report.
namespace irsg::study {

/// One way of drawing.
struct Method {
    std::string strategy; ///< "supersampling", "aligned", "sills"
    int mode = 0;         ///< 0 to 5 of the report
    /// The whole frame is sampled, as the report does it, and not only where an object is.
    bool wholeFrame = false;

    std::string name() const;
    RenderSettings settings() const;
};
std::vector<Method> methods();

struct Options {
    std::filesystem::path folder;    ///< of the CSV files
    int phases = 16;                 ///< along either axis
    int rounds = 105;                ///< frames that a median is taken of
    std::vector<std::string> bodies; ///< names of those that are looked at; empty: all
};

/// Sizes of an object, pixels, from 0.01 to 100 in equal ratios.
std::vector<double> sizes_px();

/// errors.csv: RMS and largest error of contrast intensity over phases.
void measureErrors(const Options& options);
/// angles.csv: the same for the L-shaped plate in mode 4, turned in steps of half a degree. Prints
/// how many turns fall to the lattice of samples.
void measureAngles(const Options& options);
/// times.csv: median time of a frame of 640 x 512 pixels for the same bodies and sizes.
void measureTimes(const Options& options);
/// The report's two plots: time of the four-engined aircraft and contrast intensity of the sphere
/// over range, a CSV for each method.
void measureRanges(const Options& options);
/// parts.csv: contrast intensity of the four-engined aircraft of the samples, most of whose light
/// comes from its exhaust pipes, over range, with and without windows for hot parts. Prints error
/// and time.
void measureParts(const Options& options);
/// Error of the intensity of a cold wall with 1 to 200 hot spots at 2 to 40 km, to the standard
/// output, and from behind.
void measureSpots(const Options& options);
/// The same of long thin boxes seen from their edge.
void measureNoses(const Options& options);
/// The same of the four-engined aircraft seen from all around, against windows of 2048.
void measurePolar(const Options& options);
/// Stages of a frame by body, method and size, to the standard output.
void profile(const Options& options);

} // namespace irsg::study
