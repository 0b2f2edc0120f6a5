#include "irsg/render/opengl/TileStream.h"

#include <exception>
#include <optional>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/core/Stopwatch.h"
#include "irsg/render/sampling/LayerSort.h"
#include "irsg/render/sampling/SampleEngine.h"

namespace irsg {

struct TileStream::Stream {
    Work work;
    Seconds seconds;
    std::promise<Seconds> done;
    std::exception_ptr failure; // of taking in
};

std::future<TileStream::Seconds> TileStream::start(SampleEngine& engine, Work work) {
    auto stream = std::make_shared<Stream>();
    stream->work = std::move(work);
    std::future<Seconds> done = stream->done.get_future();
    ahead_ += stream->work.drawings;
    engine.post([this, stream] { renderAll(stream); });
    return done;
}

void TileStream::renderAll(const std::shared_ptr<Stream>& stream) {
    std::exception_ptr failure;
    for (std::size_t drawing = 0; drawing < stream->work.drawings; ++drawing) {
        GeometrySamples* samples = nullptr;
        if (!failure) {
            samples = &free();
            try {
                stream->work.draw(drawing, *samples, stream->seconds);
            } catch (...) {
                failure = std::current_exception();
                giveBack(*samples);
            }
        }
        --ahead_;
        if (!failure)
            taker_.post([this, stream, drawing, samples] { takeIn(*stream, drawing, *samples); });
    }
    taker_.post([stream, failure] {
        // What the work holds may go when the future is ready, so that nothing is kept of it.
        stream->work = {};
        if (failure || stream->failure)
            stream->done.set_exception(failure ? failure : stream->failure);
        else
            stream->done.set_value(stream->seconds);
    });
}

void TileStream::takeIn(Stream& stream, std::size_t drawing, GeometrySamples& samples) {
    std::optional<OnThisThread> besideDrawing;
    if (ahead_ > 0)
        besideDrawing.emplace();
    try {
        if (!stream.failure) {
            {
                Stopwatch watch(stream.seconds.sorting);
                sortLayers(samples, stream.work.maximumLayers);
            }
            if (stream.work.shade) {
                Stopwatch watch(stream.seconds.shading);
                stream.work.shade(drawing, samples);
            }
            Stopwatch watch(stream.seconds.taking);
            stream.work.take(drawing, samples);
        }
    } catch (...) {
        stream.failure = std::current_exception();
    }
    giveBack(samples);
}

GeometrySamples& TileStream::free() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !free_.empty(); });
    GeometrySamples& samples = *free_.back();
    free_.pop_back();
    return samples;
}

void TileStream::giveBack(GeometrySamples& samples) {
    {
        const std::lock_guard lock(mutex_);
        free_.push_back(&samples);
    }
    changed_.notify_one();
}

} // namespace irsg
