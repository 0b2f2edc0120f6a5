#include "gui/HelpDialogs.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <osg/Version>
#include <qwt_global.h>

#include "gui/Theme.h"
#include "smatcore/data/Provenance.h"

namespace smat::gui {
namespace {

void lay(QDialog& dialog, QWidget* body) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, &dialog);
    buttons->button(QDialogButtonBox::Close)->setIcon({});
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    auto* column = new QVBoxLayout(&dialog);
    column->setContentsMargins(24, 20, 24, 16);
    column->setSpacing(16);
    column->addWidget(body);
    column->addWidget(buttons);
}

QString row(const QString& left, const QString& right) {
    return QStringLiteral("<tr><td style='padding:3px 18px 3px 0'><b>%1</b></td>"
                          "<td style='padding:3px 0'>%2</td></tr>")
        .arg(left, right);
}
QString heading(const QString& text) {
    return QStringLiteral(
               "<tr><td colspan='2' style='padding:12px 0 4px 0'><big>%1</big></td></tr>")
        .arg(text);
}

} // namespace

AboutDialog::AboutDialog(const QString& viewRenderer, const QString& sceneRenderer, QWidget* parent)
    : QDialog(parent) {
    setObjectName("aboutDialog");
    setWindowTitle(tr("About SMAT"));
    const QString none = tr("not used yet");
    const QString table =
        row(tr("SMAT"), QString::fromStdString(programVersion())) + row("Qt", qVersion()) +
        row("Qwt", QWT_VERSION_STR) + row("OpenSceneGraph", osgGetVersion()) +
        row(tr("3-D view"), (viewRenderer.isEmpty() ? none : viewRenderer).toHtmlEscaped()) +
        row(tr("Infrared renderer"),
            (sceneRenderer.isEmpty() ? none : sceneRenderer).toHtmlEscaped());
    auto* label = new QLabel(
        tr("<h2>SMAT</h2><p>Infrared signature modelling workbench</p><table>%1</table>"
           "<p>MIT licence. Linked libraries keep their own licences:<br>Qt and Qwt LGPL, "
           "OpenSceneGraph OSGPL, OpenEXR BSD, SQLite public domain.</p>")
            .arg(table),
        this);
    label->setObjectName("aboutText");
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    lay(*this, label);
}

ShortcutsDialog::ShortcutsDialog(QWidget* parent) : QDialog(parent) {
    setObjectName("shortcutsDialog");
    setWindowTitle(tr("Keys and mouse"));
    const QString table =
        heading(tr("Window")) + row("Ctrl+O", tr("Open a project or a model")) +
        row("Ctrl+E", tr("Export the image or plot that is shown")) +
        row("Ctrl+Z / Ctrl+Shift+Z", tr("Undo, redo")) +
        row("Ctrl+1 … Ctrl+5", tr("New image, spectrum, polar, time, range analysis")) +
        row("Esc", tr("Cancel the analysis that runs, keeping what is done")) +
        row("Ctrl+W", tr("Close the result that is shown")) + row("F1", tr("This list")) +
        row("Ctrl+Q", tr("Quit")) + heading(tr("3-D view")) +
        row(tr("Drag, arrow keys"), tr("Turn the model; with Shift in steps of 1°")) +
        row(tr("Wheel, Page up, Page down"), tr("Range of the camera")) +
        row(tr("Double click, Home"), tr("Show the whole model")) +
        row("Ctrl+Shift+W / Ctrl+Shift+A", tr("Wireframe, axes")) +
        heading(tr("Plots and images")) + row(tr("Wheel"), tr("Zoom at the cursor")) +
        row(tr("Drag"), tr("Zoom into a rectangle; statistics of it in an image")) +
        row(tr("Right drag"), tr("Move")) + row(tr("Double click"), tr("Show all")) +
        row(tr("Backspace"), tr("Take a zoom back (plots)")) +
        row(tr("Click in the legend"), tr("Hide or show a curve"));
    lay(*this, new QLabel("<table>" + table + "</table>", this));
}

} // namespace smat::gui
