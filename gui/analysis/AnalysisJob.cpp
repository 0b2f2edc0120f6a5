#include "gui/analysis/AnalysisJob.h"

#include "irsg/radiometry/Errors.h"

namespace smat::gui {

AnalysisJob::AnalysisJob(AnalysisData data, std::shared_ptr<AnalysisEngine> engine, QObject* parent)
    : QObject(parent), asked_(std::move(data)), engine_(std::move(engine)) {
    qRegisterMetaType<smat::Progress>();
    qRegisterMetaType<smat::AnalysisData>();
}

AnalysisJob::~AnalysisJob() {
    cancel();
    if (thread_.joinable())
        thread_.join();
}

void AnalysisJob::start() {
    clock_.start();
    thread_ = std::jthread([this](std::stop_token stop) { work(stop); });
}

void AnalysisJob::cancel() {
    cancelled_ = true;
    thread_.request_stop();
}

double AnalysisJob::elapsed_s() const {
    return clock_.isValid() ? static_cast<double>(clock_.elapsed()) / 1000.0 : 0.0;
}

void AnalysisJob::work(std::stop_token stop) {
    // Signals cross to the window's thread because the receivers live there.
    AnalysisData data = asked_;
    QStringList sentences;
    bool ourFault = false;
    try {
        if (!engine_->source)
            engine_->source = engine_->makeSource();
        AnalysisGenerator generator(*engine_->source,
                                    [this](const Project& project, const Settings& settings) {
                                        return engine_->scenes.build(project, settings);
                                    });
        generator.run(
            data, [this](const Progress& now) { emit progressed(now); }, stop);
    } catch (const irsg::InputError& error) {
        for (const auto& offence : error.offences())
            sentences << QString::fromStdString(offence.message());
    } catch (const std::exception& error) {
        ourFault = true;
        sentences << QString::fromLocal8Bit(error.what());
    }

    const bool nothing = data.image.empty() && data.table.empty();
    if (sentences.isEmpty() && nothing)
        sentences << (stop.stop_requested() ? tr("Cancelled before the first case was done.")
                                            : tr("The analysis gave no result."));
    if (sentences.isEmpty())
        emit finished(data);
    else
        emit failed(sentences, ourFault);
}

} // namespace smat::gui
