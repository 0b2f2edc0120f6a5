#include <exception>
#include <mutex>
#include <string>
#include <vector>

#include "python/src/Bindings.h"

namespace smat::python {

namespace {

/// Remarks of threads of ours that serve no call in particular, until the next call warns of them.
class WaitingRemarks {
  public:
    void add(const std::string& sentence) {
        const std::lock_guard lock(mutex_);
        constexpr std::size_t most = 1000;
        if (sentences_.size() < most)
            sentences_.push_back(sentence);
    }
    std::vector<std::string> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(sentences_, {});
    }

  private:
    std::mutex mutex_;
    std::vector<std::string> sentences_;
};

/// Never destroyed: threads may outlive the module.
WaitingRemarks& waitingRemarks() {
    static WaitingRemarks* const remarks = new WaitingRemarks;
    return *remarks;
}

void raiseInputError(const irsg::InputError& error) {
    const py::module_ errors = py::module_::import("smat.errors");
    const py::object diagnosticClass = errors.attr("Diagnostic");
    py::list diagnostics;
    for (const irsg::Diagnostic& one : error.diagnostics())
        diagnostics.append(diagnosticClass(one.file, one.position, one.value, one.expected));
    const py::object errorClass = errors.attr("InputError");
    PyErr_SetObject(errorClass.ptr(), errorClass(diagnostics).ptr());
}

void translate(std::exception_ptr thrown) {
    try {
        if (thrown)
            std::rethrow_exception(thrown);
    } catch (const irsg::InputError& error) {
        raiseInputError(error);
    } catch (const irsg::LogicError& error) {
        PyErr_SetString(py::module_::import("smat.errors").attr("LogicError").ptr(), error.what());
    }
}

void warn(const std::vector<std::string>& sentences) {
    py::module_::import("smat.errors").attr("warn_of")(sentences);
}

} // namespace

void warnOf(const std::vector<std::string>& sentences) {
    if (!sentences.empty())
        warn(sentences);
    if (const std::vector<std::string> waiting = waitingRemarks().take(); !waiting.empty())
        warn(waiting);
}

void addErrors(py::module_&) {
    py::register_exception_translator(translate);
    irsg::setRemarkListener([](const std::string& sentence) { waitingRemarks().add(sentence); });
}

} // namespace smat::python
