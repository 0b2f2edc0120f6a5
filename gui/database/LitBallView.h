#pragma once

#include <QImage>
#include <QWidget>

#include "irsg/radiometry/Spectrum.h"
#include "irsg/signature/SignatureDatabase.h"

namespace smat::gui {

/// A ball of a material in sun and sky as a sensor of the project's band sees it (see LitBall), in
/// grey from the darkest to the brightest of its surface, what is ten times as bright as the middle
/// of it being white.
class LitBallView : public QWidget {
    Q_OBJECT

  public:
    explicit LitBallView(QWidget* parent = nullptr);
    /// Nothing is drawn of a material whose model cannot be made.
    void show(const irsg::Material& material, const irsg::SpectralRange& band);
    const QImage& picture() const { return picture_; }
    QSize sizeHint() const override { return {150, 170}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QImage picture_;
    QString caption_;
};

} // namespace smat::gui
