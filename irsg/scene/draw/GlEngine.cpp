#include "irsg/scene/draw/GlEngine.h"

#include <algorithm>
#include <utility>

#include <osg/GLObjects>
#include <osg/RenderInfo>

#include "irsg/scene/draw/OffscreenContext.h"
#include "irsg/scene/draw/SurfacePass.h"

namespace irsg {

namespace {

/// Largest side of one drawing, samples: bounds the memory of the targets.
constexpr int largestTarget = 2048;

} // namespace

struct GlEngine::Parts {
    OffscreenContext& context = OffscreenContext::shared();
    osg::RenderInfo* info = nullptr;   // of the work under way
    std::unique_ptr<SurfacePass> pass; // made and destroyed on the context's thread
};

GlEngine::GlEngine() : parts_(std::make_unique<Parts>()) {}
GlEngine::~GlEngine() {
    parts_->context.run([&](osg::RenderInfo&) { parts_->pass.reset(); });
}

std::future<void> GlEngine::post(std::function<void()> work) {
    return parts_->context.post([p = parts_.get(), work = std::move(work)](osg::RenderInfo& info) {
        osg::flushAllDeletedGLObjects(info.getContextID());
        if (!p->pass)
            p->pass = std::make_unique<SurfacePass>();
        p->info = &info;
        work();
    });
}

std::string GlEngine::description() const {
    return parts_->context.rendererDescription();
}
int GlEngine::largestSide() const {
    return std::min(largestTarget, parts_->context.maximumTargetSize());
}

void GlEngine::drawRadiance(const SheetScene& sheet, RadianceSamples& samples) {
    parts_->pass->drawRadiance(*parts_->info, sheet, samples);
}
void GlEngine::drawFactors(const SheetScene& sheet, bool withDistance, FactorSamples& samples) {
    parts_->pass->drawFactors(*parts_->info, sheet, withDistance, samples);
}

double GlEngine::takeDrawSeconds() {
    return parts_->pass->takeDrawSeconds();
}
double GlEngine::takeReadSeconds() {
    return parts_->pass->takeReadSeconds();
}
std::size_t GlEngine::bytes() const {
    return parts_->pass ? parts_->pass->bytes() : 0;
}

} // namespace irsg
