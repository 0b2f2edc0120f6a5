#include "gui/scenario/TimeLine.h"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/widgets/FlowBar.h"
#include "gui/widgets/NumberField.h"
#include "gui/widgets/Theme.h"

namespace smat::gui {
namespace {

enum Speed { realTime, everyStep };
/// No screen shows more pictures than this.
constexpr int shortestPause_ms = 20;

} // namespace

TimeLine::TimeLine(QWidget* parent) : QWidget(parent) {
    setObjectName("timeLine");
    makeParts();
    next_.setSingleShot(true);
    connect(&next_, &QTimer::timeout, this, &TimeLine::advance);
    connect(first_, &QToolButton::clicked, this, [this] { takesKey(Qt::Key_Home); });
    connect(back_, &QToolButton::clicked, this, [this] { takesKey(Qt::Key_Left); });
    connect(play_, &QToolButton::clicked, this, [this] { takesKey(Qt::Key_Space); });
    connect(on_, &QToolButton::clicked, this, [this] { takesKey(Qt::Key_Right); });
    connect(last_, &QToolButton::clicked, this, [this] { takesKey(Qt::Key_End); });
    connect(slider_, &QSlider::valueChanged, this, [this](int value) {
        pause();
        setStep(static_cast<std::size_t>(value));
    });
    connect(time_, &NumberField::finished, this, [this] {
        // A field that is left as it was does not stop what plays.
        if (const std::size_t step = stepAt(time_->value()); step != step_) {
            pause();
            setStep(step);
        }
        refresh(); // a time between two steps is that of the nearer one
    });
    refresh();
}

QToolButton* TimeLine::button(const char* name, const char* drawing, const QString& tip) {
    auto* tool = new QToolButton(this);
    tool->setObjectName(name);
    tool->setIcon(icon(drawing));
    tool->setToolTip(tip);
    tool->setAccessibleName(tip);
    tool->setAutoRaise(true);
    tool->setFocusPolicy(Qt::TabFocus);
    return tool;
}

void TimeLine::makeParts() {
    first_ = button("firstStep", "step-first", tr("To the first step (Home)"));
    back_ = button("stepBack", "step-back", tr("One step back (Left)"));
    play_ = button("play", "play", tr("Play or stop (Space)"));
    on_ = button("stepOn", "step-on", tr("One step on (Right)"));
    last_ = button("lastStep", "step-last", tr("To the last step (End)"));
    slider_ = new QSlider(Qt::Horizontal, this);
    slider_->setObjectName("timeSlider");
    slider_->setTickPosition(QSlider::TicksBelow);
    slider_->setMinimumWidth(80);
    slider_->setAccessibleName(tr("Time"));
    time_ = new NumberField("s", this);
    time_->setObjectName("time");
    time_->setAccessibleName(tr("Time"));
    time_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    count_ = new QLabel(this);
    count_->setObjectName("stepCount");
    speed_ = new QComboBox(this);
    speed_->setObjectName("speed");
    speed_->addItem(tr("Real time"), realTime);
    speed_->addItem(tr("Every step"), everyStep);
    speed_->setToolTip(tr("How it plays: in real time, leaving out steps where pictures take "
                          "longer, or each step as soon as it is drawn"));
    auto* flow = new FlowBar(this);
    for (QToolButton* tool : {first_, back_, play_, on_, last_})
        flow->first()->addWidget(tool);
    flow->first()->addWidget(time_);
    flow->first()->addWidget(count_);
    flow->second()->addWidget(speed_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 0, 10, 4);
    column->setSpacing(2);
    column->addWidget(slider_);
    column->addWidget(flow);
}

void TimeLine::takeFocus() {
    slider_->setFocus();
}

void TimeLine::setTimes(std::vector<double> times_s) {
    const double before_s = time_s();
    const std::size_t before = step_;
    times_s_ = std::move(times_s);
    step_ = stepAt(before_s);
    refresh();
    if (step_ != before || time_s() != before_s)
        emit stepChanged();
}

std::size_t TimeLine::stepAt(double time_s) const {
    const auto nearer = [time_s](double a, double b) {
        return std::abs(a - time_s) < std::abs(b - time_s);
    };
    return static_cast<std::size_t>(std::ranges::min_element(times_s_, nearer) - times_s_.begin());
}

void TimeLine::setStep(std::size_t step) {
    step = std::min(step, times_s_.size() - 1);
    if (step == step_)
        return;
    step_ = step;
    refresh();
    emit stepChanged();
}

void TimeLine::play() {
    if (isPlaying_ || times_s_.size() < 2)
        return;
    // From the end it begins anew.
    if (step_ + 1 == times_s_.size())
        setStep(0);
    isPlaying_ = true;
    playedFrom_s_ = time_s();
    clock_.start();
    refresh();
    emit playingChanged();
}

void TimeLine::pause() {
    if (!isPlaying_)
        return;
    isPlaying_ = false;
    next_.stop();
    refresh();
    emit playingChanged();
}

void TimeLine::shown() {
    if (!isPlaying_ || next_.isActive())
        return;
    if (step_ + 1 == times_s_.size()) {
        pause();
        return;
    }
    int wait_ms = shortestPause_ms;
    if (speed_->currentData().toInt() == realTime) {
        const double due_s = times_s_[step_ + 1] - playedFrom_s_;
        const double wait_s = due_s - static_cast<double>(clock_.elapsed()) / 1000.0;
        wait_ms = static_cast<int>(std::clamp(wait_s * 1000.0, 0.0, 1e9));
    }
    next_.start(wait_ms);
}

void TimeLine::advance() {
    std::size_t step = step_ + 1;
    if (speed_->currentData().toInt() == realTime) {
        // The last step whose time has come.
        const double now_s = playedFrom_s_ + static_cast<double>(clock_.elapsed()) / 1000.0;
        while (step + 1 < times_s_.size() && times_s_[step + 1] <= now_s)
            ++step;
    }
    setStep(step);
}

bool TimeLine::takesKey(int key) {
    if (key == Qt::Key_Space) {
        isPlaying_ ? pause() : play();
        return true;
    }
    std::size_t wanted = step_;
    if (key == Qt::Key_Left)
        wanted = step_ > 0 ? step_ - 1 : 0;
    else if (key == Qt::Key_Right)
        wanted = step_ + 1;
    else if (key == Qt::Key_Home)
        wanted = 0;
    else if (key == Qt::Key_End)
        wanted = times_s_.size() - 1;
    else
        return false;
    pause();
    setStep(wanted);
    return true;
}

void TimeLine::keyPressEvent(QKeyEvent* event) {
    // What the slider leaves; a field has its own arrows.
    if (event->modifiers() != Qt::NoModifier || !takesKey(event->key()))
        QWidget::keyPressEvent(event);
}

void TimeLine::refresh() {
    const QSignalBlocker quiet(slider_);
    const int steps = static_cast<int>(times_s_.size());
    slider_->setRange(0, steps - 1);
    slider_->setPageStep(std::max(1, steps / 10));
    slider_->setTickInterval(std::max(1, steps / 20));
    slider_->setValue(static_cast<int>(step_));
    slider_->setEnabled(steps > 1);
    time_->setRange(times_s_.front(), times_s_.back());
    // In nine digits: steps are sums of tenths.
    time_->setValue(QString::number(time_s(), 'g', 9).toDouble());
    count_->setText(tr("step %1 of %2").arg(step_ + 1).arg(steps));
    play_->setIcon(icon(isPlaying_ ? "pause" : "play"));
    play_->setEnabled(steps > 1);
    first_->setEnabled(step_ > 0);
    back_->setEnabled(step_ > 0);
    on_->setEnabled(static_cast<int>(step_) + 1 < steps);
    last_->setEnabled(static_cast<int>(step_) + 1 < steps);
}

} // namespace smat::gui

#include "moc_TimeLine.cpp"
