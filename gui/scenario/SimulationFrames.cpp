#include "gui/scenario/SimulationFrames.h"

#include <algorithm>
#include <cmath>

namespace smat::gui {
namespace {

constexpr int thumbnailWidth_px = 112;

WrittenFrame smallCopy(const SensorFrame& frame, std::size_t number) {
    const irsg::RadianceImage& image = frame.rendered.image;
    const std::vector<float>& values = image.primary().values;
    WrittenFrame written;
    written.sensor = frame.sensor;
    written.band = frame.band;
    written.number = number;
    written.time_s = frame.time_s;
    // What is small and hot stays to be seen: the largest of the pixels that become one.
    const int step = std::max(1, (image.width() + thumbnailWidth_px - 1) / thumbnailWidth_px);
    written.width = (image.width() + step - 1) / step;
    written.height = (image.height() + step - 1) / step;
    written.values.assign(static_cast<std::size_t>(written.width) *
                              static_cast<std::size_t>(written.height),
                          std::nanf(""));
    written.low = INFINITY;
    written.high = -INFINITY;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const float value = values[image.offset(x, y)];
            if (!std::isfinite(value))
                continue;
            float& small = written.values[static_cast<std::size_t>(y / step * written.width) +
                                          static_cast<std::size_t>(x / step)];
            if (std::isnan(small) || value > small)
                small = value;
            written.low = std::min(written.low, static_cast<double>(value));
            written.high = std::max(written.high, static_cast<double>(value));
        }
    }
    return written;
}

} // namespace

SimulationFrames runSimulation(const SimulationJob& job, JobRunner& runner,
                               const JobControl& control) {
    SimulationFrames made{.order = job};
    PlannedSimulation planned = runner.plan(job);
    planned.keepsStrips = true;
    made.notes = planned.files().makeFolders(planned.plan.sensors);
    SimulationOutcome outcome =
        runner.run(planned, control, [&](SensorFrame& frame, std::size_t number) {
            made.frames.push_back(smallCopy(frame, number));
        });
    made.result = std::move(outcome.result);
    made.films = std::move(outcome.strips);
    return made;
}

} // namespace smat::gui
