#include "gui/tools/Calculation.h"

#include "gui/Sentences.h"
#include "irsg/radiometry/Errors.h"

namespace smat::gui {

Calculation::~Calculation() {
    for (auto& worker : workers_)
        worker.thread.join();
}

void Calculation::start(Work work) {
    std::erase_if(workers_, [](const Worker& worker) { return worker.done->load(); });
    const int number = ++number_;
    running_ = true;
    auto done = std::make_shared<std::atomic<bool>>(false);
    workers_.push_back(
        {done, std::jthread([this, number, done, work = std::move(work)] {
             std::function<void()> take;
             QStringList sentences;
             try {
                 take = work();
             } catch (const irsg::InputError& error) {
                 sentences << sentencesOf(error);
             } catch (const std::exception& error) {
                 sentences << tr("Internal error: %1").arg(error.what());
             }
             QMetaObject::invokeMethod(
                 this, [this, number, take, sentences] { answer(number, take, sentences); },
                 Qt::QueuedConnection);
             done->store(true);
         })});
    emit started();
}

void Calculation::cancel() {
    if (!running_)
        return;
    ++number_;
    running_ = false;
    emit ended();
}

void Calculation::answer(int number, const std::function<void()>& take,
                         const QStringList& sentences) {
    if (number != number_)
        return;
    running_ = false;
    if (sentences.isEmpty())
        take();
    else
        emit refused(sentences);
    emit ended();
}

} // namespace smat::gui
