#pragma once

#include <functional>
#include <future>
#include <memory>
#include <string>

namespace irsg {

/// An OpenGL context of IRSG's own, on a thread of its own: EGL on a device where there is one,
/// Mesa without a surface otherwise. No display and no window are needed, and because nothing is
/// ever made current on the caller's thread, whatever the caller (a Qt widget, say) has current
/// stays so.
///
/// All generators of a process share one context, so that models can be shared between them and a
/// thousand analyses need no more GL than one.
class OffscreenContext {
  public:
    /// The shared context, made at the first call and kept until the process ends: drivers are not
    /// robust against contexts that come and go on threads that come and go. Throws InputError that
    /// says which step failed when the machine offers no OpenGL 4.5 compatibility context; the
    /// next call tries again.
    static OffscreenContext& shared();

    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    /// Runs `work` on the context's thread and waits; what it throws is thrown here.
    void run(const std::function<void()>& work);
    /// The same without waiting: work is done in the order in which it comes.
    std::future<void> post(std::function<void()> work);

    /// "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Compatibility Profile) Mesa 22.3.6".
    const std::string& rendererDescription() const;
    /// Largest side of a render target, samples.
    int maximumTargetSize() const;

  private:
    OffscreenContext();
    ~OffscreenContext();

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace irsg
