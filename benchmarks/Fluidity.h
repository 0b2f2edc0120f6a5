#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

/// Holds what people do by hand against 30 frames a second.
class Fluidity {
  public:
    /// The usual time of a frame.
    void validate(const std::string& what, double frame_ms) {
        if (frame_ms > allowed_ms)
            tooSlow_ += (tooSlow_.empty() ? "" : ", ") + what;
    }
    /// Says which were slower, and gives the exit code of the program.
    int verdict() const {
        std::printf("30 frames a second: %s%s\n", tooSlow_.empty() ? "held by all" : "NOT by ",
                    tooSlow_.c_str());
        return tooSlow_.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
    }

  private:
    static constexpr double allowed_ms = 1000.0 / 30.0;
    std::string tooSlow_;
};
