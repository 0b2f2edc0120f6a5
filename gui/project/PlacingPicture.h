#pragma once

#include <memory>

#include <QImage>
#include <QWidget>

#include "irsg/geometry/model/ModelPlacing.h"

namespace smat::gui {

/// A model from port, from ahead and from above, as a placing would have it, with a man of 1.8 m
/// beside it: whether up, nose and unit are right is seen at a glance.
class PlacingPicture : public QWidget {
    Q_OBJECT

  public:
    explicit PlacingPicture(QWidget* parent = nullptr);

    void show(std::shared_ptr<const irsg::ModelShape> shape, const irsg::ModelPlacing& placing);
    /// A word in place of the picture.
    void showWord(const QString& word);
    QSize sizeHint() const override { return {520, 210}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    std::shared_ptr<const irsg::ModelShape> shape_;
    irsg::ModelPlacing placing_;
    QString word_;
};

} // namespace smat::gui
