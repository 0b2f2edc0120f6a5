#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <vector>

#include "irsg/core/TaskThread.h"
#include "irsg/render/sampling/Samples.h"

namespace irsg {

class SampleEngine;

/// Makes drawings, of one tile or several, one after the other on an engine's thread while what
/// was drawn before is sorted and taken in on another thread, and on all cores once all is drawn:
/// two sets of samples take turns. The first drawing of a stream is made while the last one of the
/// stream before is taken in.
class TileStream {
  public:
    /// Time that a stream took on its threads, s.
    struct Seconds {
        double drawing = 0.0, reading = 0.0, sorting = 0.0, shading = 0.0, taking = 0.0;
    };
    struct Work {
        std::size_t drawings = 0;
        int maximumLayers = 0;
        /// On the engine's thread; adds to `drawing` and `reading`.
        std::function<void(std::size_t drawing, GeometrySamples&, Seconds&)> draw;
        /// What is left to do to sorted layers, or nothing.
        std::function<void(std::size_t drawing, GeometrySamples&)> shade = {};
        /// In the order of the drawings, with sorted layers.
        std::function<void(std::size_t drawing, const GeometrySamples&)> take;
    };

    /// Returns at once. The future is ready when all is drawn and taken in, or has failed, and then
    /// throws why; what the work refers to must live until then, the engine beyond it.
    std::future<Seconds> start(SampleEngine& engine, Work work);

  private:
    struct Stream;
    void renderAll(const std::shared_ptr<Stream>& stream);
    void takeIn(Stream& stream, std::size_t drawing, GeometrySamples& samples);
    GeometrySamples& free();
    void giveBack(GeometrySamples& samples);

    std::atomic<std::size_t> ahead_ = 0; // drawings that are not made yet
    std::mutex mutex_;
    std::condition_variable changed_;
    std::array<GeometrySamples, 2> samples_;
    std::vector<GeometrySamples*> free_{&samples_[0], &samples_[1]};
    TaskThread taker_; // last: what it does uses all others
};

} // namespace irsg
