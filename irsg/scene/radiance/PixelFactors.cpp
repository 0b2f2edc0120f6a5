#include "irsg/scene/radiance/PixelFactors.h"

#include <limits>

#include "irsg/radiometry/Errors.h"

namespace irsg {

PixelFactors::PixelFactors(const Sensor& sensor, std::vector<bool> transparent)
    : width_px_(static_cast<std::size_t>(sensor.width_px)),
      transparent_(std::move(transparent)),
      heads_(width_px_ * static_cast<std::size_t>(sensor.height_px), -1) {}

PixelFactors::Entry& PixelFactors::entry(int x, int y, std::int32_t row, std::int32_t front) {
    std::int32_t& head =
        heads_[static_cast<std::size_t>(y) * width_px_ + static_cast<std::size_t>(x)];
    for (std::int32_t i = head; i >= 0; i = entries_[static_cast<std::size_t>(i)].next)
        if (Entry& known = entries_[static_cast<std::size_t>(i)];
            known.row == row && known.front == front)
            return known;
    if (entries_.size() >= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
        throw LogicError("more surfaces in the pixels of a view than can be counted");
    Entry& made = entries_.emplace_back();
    made.row = row;
    made.front = front;
    made.next = std::exchange(head, static_cast<std::int32_t>(entries_.size() - 1));
    return made;
}

std::int32_t PixelFactors::behind(std::int32_t front, std::int32_t row) {
    const auto [place, isNew] =
        known_.try_emplace({front, row}, static_cast<std::int32_t>(fronts_.size()));
    if (isNew)
        fronts_.push_back({front, row});
    return place->second;
}

void PixelFactors::add(const SampleWindow& window, const FactorSamples& samples) {
    const double share = window.share();
    window.forEachRun([&](std::size_t first, int count, int x, int y, double weight) {
        const auto part = static_cast<float>(weight * share);
        const std::size_t last = first + static_cast<std::size_t>(count);
        for (std::size_t i = first; i < last; ++i) {
            std::int32_t front = 0;
            for (std::uint32_t k = samples.first[i]; k < samples.first[i + 1]; ++k) {
                const FactorLayer& layer = samples.layers[k];
                Entry& sums = entry(x, y, layer.row, front);
                sums.thermal += part * layer.thermal;
                sums.up += part * layer.up;
                sums.down += part * layer.down;
                sums.sun += part * layer.sun;
                sums.coverage += part;
                if (transparent_[static_cast<std::size_t>(layer.row)])
                    front = behind(front, layer.row);
            }
        }
    });
}

void PixelFactors::finish() {
    std::vector<Entry> sorted;
    sorted.reserve(entries_.size());
    for (std::size_t pixel = 0; pixel < heads_.size(); ++pixel) {
        if (heads_[pixel] < 0)
            continue;
        for (std::int32_t i = heads_[pixel]; i >= 0; i = entries_[static_cast<std::size_t>(i)].next)
            sorted.push_back(entries_[static_cast<std::size_t>(i)]);
        pixels_.push_back({static_cast<std::int32_t>(pixel % width_px_),
                           static_cast<std::int32_t>(pixel / width_px_), sorted.size()});
    }
    entries_ = std::move(sorted);
    heads_ = {};
    known_.clear();
}

void PixelFactors::evaluate(const std::vector<SurfaceRow>& rows, FrameReduction& pixels) const {
    // What is left of the light behind the layers in front; those of the longer ones come later.
    std::vector<double> passed{1.0};
    for (std::size_t i = 1; i < fronts_.size(); ++i) {
        const SurfaceRow& row = rows[static_cast<std::size_t>(fronts_[i].row)];
        passed.push_back(passed[static_cast<std::size_t>(fronts_[i].before)] *
                         (1.0 - static_cast<double>(row.opacity)));
    }
    std::size_t i = 0;
    for (const Pixel& pixel : pixels_) {
        double radiance = 0.0, opacity = 0.0;
        for (; i < pixel.end; ++i) {
            const Entry& sums = entries_[i];
            const SurfaceRow& row = rows[static_cast<std::size_t>(sums.row)];
            const float leaving = sums.thermal * row.thermal + sums.up * row.up +
                                  sums.down * row.down + sums.sun * row.sun +
                                  sums.coverage * row.path;
            const double seen = passed[static_cast<std::size_t>(sums.front)];
            radiance += seen * static_cast<double>(leaving);
            opacity += seen * static_cast<double>(sums.coverage) * static_cast<double>(row.opacity);
        }
        pixels.addPoint(pixel.x, pixel.y, radiance, opacity);
    }
}

} // namespace irsg
