#include "gui/tools/Calculation.h"

#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"

namespace smat::gui {

void Calculation::start(Work work) {
    running_ = true;
    clock_.start();
    task_.run<std::function<void()>>(
        std::move(work),
        [this](const std::function<void()>& take) {
            running_ = false;
            take();
            emit ended();
        },
        [this](const std::exception_ptr& thrown) { refuse(thrown); });
    emit started();
}

void Calculation::cancel() {
    if (!running_)
        return;
    task_.cancel();
    running_ = false;
    emit ended();
}

double Calculation::elapsed_s() const {
    return clock_.isValid() ? static_cast<double>(clock_.elapsed()) / 1000.0 : 0.0;
}

void Calculation::refuse(const std::exception_ptr& thrown) {
    running_ = false;
    try {
        std::rethrow_exception(thrown);
    } catch (const irsg::InputError& error) {
        emit refused(sentencesOf(error));
    } catch (const std::exception& error) {
        emit refused({tr("Internal error: %1").arg(error.what())});
    }
    emit ended();
}

} // namespace smat::gui

#include "moc_Calculation.cpp"
