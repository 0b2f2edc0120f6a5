#pragma once

#include <functional>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/scene/Scene.h"

namespace irsg {

/// What was begun by Renderer::begin, to be taken once. It must not outlive its renderer.
class PendingRender {
  public:
    using Finish = std::function<Rendered()>;

    /// `finish` is called once, by get(). `isDrawnBeside`: it goes on by itself meanwhile.
    explicit PendingRender(Finish finish, bool isDrawnBeside = false)
        : finish_(std::move(finish)), isDrawnBeside_(isDrawnBeside) {}
    PendingRender(PendingRender&&) = default;
    PendingRender& operator=(PendingRender&&) = default;
    PendingRender(const PendingRender&) = delete;
    PendingRender& operator=(const PendingRender&) = delete;
    ~PendingRender() = default;

    /// Waits for what comes out. Throws what failed in drawing; LogicError when it was taken
    /// before.
    Rendered get() {
        if (!finish_)
            throw LogicError("what was begun was taken twice");
        return std::exchange(finish_, nullptr)();
    }
    /// True where it is worth beginning the next view before this one is taken.
    bool isDrawnBeside() const { return isDrawnBeside_; }

  private:
    Finish finish_;
    bool isDrawnBeside_;
};

} // namespace irsg
