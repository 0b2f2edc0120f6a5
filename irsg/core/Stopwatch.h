#pragma once

#include <chrono>

namespace irsg {

/// Adds the time it lives to a total, s.
class Stopwatch {
  public:
    explicit Stopwatch(double& total_s) : total_s_(total_s) {}
    ~Stopwatch() {
        total_s_ +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    double& total_s_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace irsg
