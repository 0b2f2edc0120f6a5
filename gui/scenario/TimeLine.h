#pragma once

#include <vector>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace smat::gui {

class NumberField;

/// The steps of a scenario as a line of time: a slider over them with the time as a number, one
/// step on or back, and playing, either as fast as the clock or every step as soon as it is drawn.
/// Keys: Space plays and stops, Left and Right step, Home and End go to the ends.
class TimeLine : public QWidget {
    Q_OBJECT

  public:
    explicit TimeLine(QWidget* parent = nullptr);

    /// At least one, ascending; the step is the one nearest to the time of before.
    void setTimes(std::vector<double> times_s);
    const std::vector<double>& times_s() const { return times_s_; }
    std::size_t step() const { return step_; }
    double time_s() const { return times_s_.at(step_); }
    void setStep(std::size_t step);
    void takeFocus();
    bool isPlaying() const { return isPlaying_; }
    void play();
    void pause();
    /// Whoever shows the steps says when it has shown the one that is set, and when playing begins
    /// that it is shown already: playing goes on.
    void shown();
    /// Whether a key is one of the line, which did then what it stands for.
    bool takesKey(int key);

  signals:
    void stepChanged();
    void playingChanged();

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QToolButton* button(const char* name, const char* drawing, const QString& tip);
    void makeParts();
    void advance();
    void refresh();
    std::size_t stepAt(double time_s) const;

    std::vector<double> times_s_{0.0};
    std::size_t step_ = 0;
    bool isPlaying_ = false;
    QElapsedTimer clock_;
    double playedFrom_s_ = 0.0;
    QTimer next_;
    QSlider* slider_ = nullptr;
    NumberField* time_ = nullptr;
    QLabel* count_ = nullptr;
    QToolButton *first_ = nullptr, *back_ = nullptr, *play_ = nullptr, *on_ = nullptr,
                *last_ = nullptr;
    QComboBox* speed_ = nullptr;
};

} // namespace smat::gui
