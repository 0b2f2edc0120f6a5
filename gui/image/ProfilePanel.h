#pragma once

#include <QLine>
#include <QPoint>
#include <QWidget>

#include "gui/widgets/Dialogs.h"
#include "irsg/image/RadianceImage.h"

namespace smat::gui {

class PlotPanel;

/// A plot of the values of an image along a line, or along the row and the column of a pixel.
class ProfilePanel : public QWidget {
    Q_OBJECT

  public:
    explicit ProfilePanel(Dialogs dialogs, QWidget* parent = nullptr);

    /// `title` is the quantity of the plane with its unit.
    void showLine(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                  const QString& title, const QLine& line);
    void showPoint(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                   const QString& title, const QPoint& pixel);
    /// What is to be done for a profile to appear.
    void showHint();
    PlotPanel* plot() const { return plot_; }

  private:
    PlotPanel* plot_ = nullptr;
};

} // namespace smat::gui
