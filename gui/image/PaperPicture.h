#pragma once

#include <QImage>
#include <QString>

#include "irsg/image/PngView.h"

namespace smat::gui {

class ColorBar;
class IndexLegend;

/// A picture as it is exported, whatever shows it: on paper, its title and conditions above it and
/// the colour bar beside it, in the font of plots.
struct PaperPicture {
    QImage picture; ///< with its own device pixel ratio, which becomes that of the whole
    QString title = {}, conditions = {};
    const ColorBar* bar = nullptr;
    const IndexLegend* legend = nullptr; ///< in place of a bar
};
QImage onPaper(const PaperPicture& parts);

/// A plane with the colours of a bar, pixel by pixel, small ones enlarged by a whole number.
QImage enlargedPlane(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                     const ColorBar& bar);
/// A picture that has its colours, likewise.
QImage enlarged(const QImage& picture);

} // namespace smat::gui
