#include "irsg/render/opengl/GlEngine.h"

#include <algorithm>
#include <utility>

#include "irsg/render/opengl/MeshBuffers.h"
#include "irsg/render/opengl/OffscreenContext.h"
#include "irsg/render/opengl/SurfacePass.h"

namespace irsg {

struct GlEngine::Impl {
    OffscreenContext& context = OffscreenContext::shared();
    std::unique_ptr<SurfacePass> pass; // made and destroyed on the context's thread
};

GlEngine::GlEngine() : impl_(std::make_unique<Impl>()) {}
GlEngine::~GlEngine() {
    impl_->context.run([&] { impl_->pass.reset(); });
}

std::future<void> GlEngine::post(std::function<void()> work) {
    return impl_->context.post([p = impl_.get(), work = std::move(work)] {
        MeshBuffers::forgetGone();
        if (!p->pass)
            p->pass = std::make_unique<SurfacePass>();
        work();
    });
}

std::string GlEngine::description() const {
    return impl_->context.rendererDescription();
}
int GlEngine::largestSide() const {
    return std::min(largestDrawing, impl_->context.maximumTargetSize());
}

void GlEngine::renderRadiance(const SheetScene& sheet, RadianceSamples& samples) {
    impl_->pass->renderRadiance(sheet, samples);
}
void GlEngine::sampleGeometry(const SheetScene& sheet, bool withDistance,
                              GeometrySamples& samples) {
    impl_->pass->sampleGeometry(sheet, withDistance, samples);
}

double GlEngine::takeRenderSeconds() {
    return impl_->pass->takeRenderSeconds();
}
double GlEngine::takeReadSeconds() {
    return impl_->pass->takeReadSeconds();
}
std::size_t GlEngine::bytes() const {
    return impl_->pass ? impl_->pass->bytes() : 0;
}

} // namespace irsg
