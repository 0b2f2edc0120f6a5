#pragma once

#include <filesystem>
#include <string>

#include <QColor>
#include <QFont>
#include <QImage>
#include <QPointF>
#include <QWidget>

namespace smat::gui::test {

/// Keeps a picture of a window for a person to look at: screenshots/NAME.png in the build folder.
void keepScreenshot(QWidget& widget, const std::string& name);

/// Whether a widget shows a colour, or one much like it, within three pixels of a point.
bool showsColorAt(QWidget& widget, const QPointF& point, const QColor& wanted);

/// What a picture of a widget shows at a point of the widget, of which a high density screen makes
/// several pixels.
QColor colorAt(const QImage& picture, const QPointF& point);

/// Whether a picture on paper has a text in a font, in whatever shade of grey.
bool holdsWords(const QImage& picture, const QString& words, const QFont& font);

/// Has the clipboard, which tests that run side by side on one display share, to this process until
/// it ends. Called first by every test that copies or pastes.
void keepClipboard();

/// Whether this desktop gives windows no OpenGL. A test that needs it is skipped then; where the
/// environment sets SMAT_GL_REQUIRED it fails, so that a run without a failure has drawn.
bool lacksGl();

/// A folder of its own for each test, emptied first.
std::filesystem::path freshFolder(const std::string& name);

} // namespace smat::gui::test
