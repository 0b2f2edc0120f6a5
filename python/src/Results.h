#pragma once

#include <exception>
#include <memory>
#include <stop_token>

#include "python/src/Bindings.h"
#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/support/Progress.h"

namespace smat::python {

void addResults(py::module_& module);

/// Passes the progress of a job to a Python function and looks for Ctrl-C, between cases. What the
/// function raises, and Ctrl-C, stop the job and are raised by finish(); a function that returns
/// False stops it, too, and what was done stays. To be made and destroyed with the lock of the
/// interpreter.
class PythonProgress {
  public:
    explicit PythonProgress(py::object function) : function_(std::move(function)) {}
    PythonProgress(const PythonProgress&) = delete;
    PythonProgress& operator=(const PythonProgress&) = delete;

    /// Takes the lock. Must not outlive this.
    ProgressCallback callback() {
        return [this](const Progress& progress) { tell(progress); };
    }
    std::stop_token stop() const { return stop_.get_token(); }
    void finish() const {
        if (raised_)
            std::rethrow_exception(raised_);
    }

  private:
    void tell(const Progress& progress);

    py::object function_;
    std::stop_source stop_;
    std::exception_ptr raised_;
};

} // namespace smat::python
