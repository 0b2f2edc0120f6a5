#pragma once

#include "irsg/render/opengl/GlFunctions.h"

namespace irsg {

/// Depth from 1 near to 0 far, for as long as it lives.
class ReversedDepth {
  public:
    ReversedDepth() { glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); }
    ~ReversedDepth() {
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
        glDepthFunc(GL_LESS);
        glClearDepth(1.0);
    }
    ReversedDepth(const ReversedDepth&) = delete;
    ReversedDepth& operator=(const ReversedDepth&) = delete;
};

} // namespace irsg
