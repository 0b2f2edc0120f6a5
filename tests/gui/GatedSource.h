#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "irsg/core/StageReport.h"
#include "tests/core/AnalyticSource.h"

namespace smat::gui::test {

/// Lets drawings of the renderers below begin and end as a test says.
class Gate {
  public:
    void drawings(int allowed) {
        const std::lock_guard lock(mutex_);
        allowed_ = allowed;
        changed_.notify_all();
    }
    void pass() {
        std::unique_lock lock(mutex_);
        ++begun;
        changed_.notify_all();
        changed_.wait(lock, [this] { return allowed_ > 0; });
        --allowed_;
    }
    std::atomic<int> begun = 0, renderers = 0;

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int allowed_ = 1 << 30;
};

/// A sphere whose drawings take as long as the gate is shut.
class GatedSource : public smat::test::AnalyticSource {
  public:
    explicit GatedSource(Gate& gate) : gate_(gate) { ++gate_.renderers; }
    ~GatedSource() override { --gate_.renderers; }
    double intensity_W_sr(const irsg::Vec3&) const override { return 3.0; }
    double projectedArea_m2(const irsg::Vec3&) const override { return 1.0; }
    irsg::RenderReport measure() override {
        const irsg::StageScope scope("gate");
        irsg::StageCount count("waiting", 4);
        count.add();
        gate_.pass();
        return AnalyticSource::measure();
    }

  private:
    Gate& gate_;
};

/// The door to one of its own.
inline RenderDoor gatedDoor(Gate& gate) {
    const auto source = std::make_shared<GatedSource>(gate);
    RenderDoor door = source->door();
    door.begin = [source, begin = door.begin](
                     const irsg::Scene& scene, const irsg::SensorView& view,
                     const irsg::Outputs& outputs) { return begin(scene, view, outputs); };
    return door;
}

} // namespace smat::gui::test
