#include "gui/view/InfraredDisplay.h"

#include <algorithm>

#include "gui/view/InfraredScene.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"

namespace smat::gui {

InfraredDisplay::InfraredDisplay(QObject* parent) : QObject(parent) {
    qRegisterMetaType<smat::gui::InfraredPicture>();
    connect(
        this, &InfraredDisplay::answered, this,
        [this](long number) {
            answered_ = std::max(answered_, number);
            waiting_.restart();
        },
        Qt::QueuedConnection);
}

InfraredDisplay::~InfraredDisplay() {
    thread_.request_stop();
    if (thread_.joinable())
        thread_.join();
}

void InfraredDisplay::ask(InfraredRequest request) {
    if (!isBusy())
        waiting_.start();
    {
        const std::scoped_lock lock(mutex_);
        next_ = std::move(request);
        nextNumber_ = ++asked_;
    }
    changed_.notify_one();
    if (!thread_.joinable())
        thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

void InfraredDisplay::forget() {
    const std::scoped_lock lock(mutex_);
    if (next_) {
        next_.reset();
        answered_ = asked_;
    }
}

double InfraredDisplay::waiting_s() const {
    return isBusy() ? static_cast<double>(waiting_.elapsed()) / 1000.0 : 0.0;
}

void InfraredDisplay::work(const std::stop_token& stop) {
    // The renderer lives and dies in this thread.
    std::optional<InfraredScene> scene;
    const CurrentStage::Listening listening(stage_);
    while (true) {
        InfraredRequest request;
        long number = 0;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [this] { return next_.has_value(); }))
                return;
            request = std::move(*next_);
            next_.reset();
            number = nextNumber_;
        }

        // What a picture cannot be made of is told in words, as an analysis tells it.
        QStringList sentences;
        bool ourFault = false;
        InfraredPicture picture;
        try {
            if (!scene)
                scene.emplace();
            picture = scene->draw(request);
        } catch (const irsg::InputError& error) {
            sentences << sentencesOf(error);
        } catch (const std::exception& error) {
            ourFault = true;
            sentences << QString::fromLocal8Bit(error.what());
        }
        emit answered(number);
        if (sentences.isEmpty())
            emit drawn(picture);
        else
            emit failed(sentences, ourFault);
    }
}

} // namespace smat::gui

#include "moc_InfraredDisplay.cpp"
