#pragma once

#include <QColor>
#include <QPalette>

/// The colours that have a meaning beside those of the palette (Theme.h), named by it, in a shade
/// for light and one for dark palettes. Rooms of the window name no colour of their own:
/// scripts/style looks for it. Colours that data have (colour maps, measured reflectances) are no
/// part of this.
namespace smat::gui::colors {

/// Behind a value that cannot stand as it is.
QColor wrongField(const QPalette& palette);
/// A sentence about what is wrong.
QColor errorText(const QPalette& palette);
/// The name of something in need of attention.
QColor warningText(const QPalette& palette);
/// A strip that asks for a decision, and its frame.
QColor notice(const QPalette& palette);
QColor noticeFrame(const QPalette& palette);

/// Around an image.
QColor imageSurround(const QPalette& palette);
/// A frame or line over an image of any colours, and the wider line under it that lets it be seen.
QColor imageMark();
QColor imageMarkSeam();
/// The thin outline of windows in an image, over a seam.
QColor outline();
QColor outlineSeam();
/// Text upon a pixel of this colour.
QColor textUpon(const QColor& pixel);
/// Pixels over the warning and over the failure threshold of a comparison.
QColor warnedPixel();
QColor failedPixel();

/// Behind the white verdict of a comparison.
QColor verdictPass();
QColor verdictWarning();
QColor verdictFailure();
/// The images differ and no threshold says whether that is bad.
QColor verdictDifferent();

/// Words and plates over a picture.
QColor overlayInk(bool dark);
QColor overlayPaper(bool dark);
/// 0 starboard or east, 1 nose or north, 2 up.
QColor axis(int which);
QColor sun();
QColor sunRim();
/// Where the camera of an entity's own window sees.
QColor tileFrustum();
/// Meridians and circles on the ball of a signature table.
QColor ballLine(bool dark);
/// The frame of a sentence about why there is no picture.
QColor problemFrame();
/// A face whose index has no colour.
QColor unknownIndex();
/// The sample of an entry that is a measured spectrum and has no temperature.
QColor measuredEntry();
/// Behind all that is exported to paper.
QColor paper();

} // namespace smat::gui::colors
