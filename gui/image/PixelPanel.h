#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QWidget>

#include "gui/widgets/LatestTask.h"
#include "smatcore/analysis/PixelText.h"

class QLabel;
class QToolButton;
class QTreeWidget;

namespace smat {
class PixelExplainer;
}

namespace smat::gui {

/// What a pixel of an image is made of: its surfaces, nearest first, with the terms of each and the
/// values that entered, then the background, and the sum beside what was drawn. The image is drawn
/// anew, once, off the window's thread, before the first answer.
class PixelPanel : public QWidget {
    Q_OBJECT

  public:
    /// Makes the explainer of the image, in another thread; throws irsg::InputError with what is in
    /// the way.
    using Work = std::function<std::shared_ptr<PixelExplainer>()>;
    /// Asked for it in the window's thread, of what is open then.
    using Maker = std::function<Work()>;

    explicit PixelPanel(QWidget* parent = nullptr);

    /// Of another image, or of none.
    void setMaker(Maker maker);
    bool canExplain() const { return static_cast<bool>(maker_); }
    /// Draws the image where that is not done yet.
    void prepare();
    /// Explains a pixel; `inImage` is what the image says of it, W m-2 sr-1, where it does.
    void ask(const QPoint& pixel, const std::optional<double>& inImage);

    /// The answer that is shown; none before the first one and where there is none.
    const std::optional<ExplainedPixel>& answer() const { return answer_; }
    /// As `smat-batch explain` prints it; empty without an answer.
    QString text() const;
    /// Why there is no answer; empty where there is one.
    QString problem() const;
    bool isBusy() const { return making_.isBusy() || asking_.isBusy(); }
    void copy() const;

  signals:
    void answered();

  private:
    void explain();
    void show(const ExplainedPixel& pixel);
    void fail(const std::exception_ptr& thrown);

    Maker maker_;
    std::shared_ptr<PixelExplainer> explainer_;
    std::optional<QPoint> asked_;
    std::optional<double> inImage_;
    std::optional<ExplainedPixel> answer_;
    bool hasFailed_ = false;
    QLabel *title_ = nullptr, *words_ = nullptr;
    QTreeWidget* tree_ = nullptr;
    QToolButton* copy_ = nullptr;
    LatestTask making_, asking_;
};

} // namespace smat::gui
