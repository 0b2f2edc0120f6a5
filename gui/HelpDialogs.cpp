#include "gui/HelpDialogs.h"

#include <OpenEXRConfig.h>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QTabWidget>
#include <QVBoxLayout>
#include <osg/Version>
#include <qwt_global.h>
#include <sqlite3.h>

#include "gui/image/ComparisonKeys.h"
#include "gui/image/ImageView.h"
#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/VerticalScrollArea.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/scene/scattering/SceneScattering.h"
#include "smatcore/data/Provenance.h"

namespace smat::gui {
namespace {

void lay(QDialog& dialog, QWidget* body) {
    auto* buttons = closeAlone(dialog);
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

/// "Save project as" from "Save project &as…".
QString withoutMarks(QString text) {
    return text.remove('&').remove(QStringLiteral("…"));
}

QString keyRows(const QList<QAction*>& actions) {
    QString rows;
    for (const auto* action : actions) {
        QStringList keys;
        for (const auto& sequence : action->shortcuts())
            keys << sequence.toString(QKeySequence::NativeText);
        // Undo and redo say what they would undo now.
        const QString text = action->property("listedAs").isValid()
                                 ? action->property("listedAs").toString()
                                 : withoutMarks(action->text());
        if (action->menu() != nullptr)
            rows += keyRows(action->menu()->actions());
        else if (!keys.isEmpty())
            rows += row(keys.join(QStringLiteral(" / ")), text.toHtmlEscaped());
    }
    return rows;
}

} // namespace

AboutDialog::AboutDialog(const QString& viewRenderer, const QString& sceneRenderer, QWidget* parent)
    : QDialog(parent) {
    setObjectName("aboutDialog");
    setWindowTitle(tr("About SMAT"));
    const QString none = tr("not used yet");
    const QString table =
        row(tr("SMAT"), QString::fromStdString(irsg::programVersion())) + row("Qt", qVersion()) +
        row("Qwt", QWT_VERSION_STR) + row("OpenSceneGraph", osgGetVersion()) +
        row("OpenEXR", OPENEXR_VERSION_STRING) + row("SQLite", sqlite3_libversion()) +
        row(tr("3-D view"), (viewRenderer.isEmpty() ? none : viewRenderer).toHtmlEscaped()) +
        row(tr("Infrared renderer"),
            (sceneRenderer.isEmpty() ? none : sceneRenderer).toHtmlEscaped());
    auto* label = new QLabel(
        tr("<h2>SMAT</h2><p>Infrared signature modelling workbench</p><table>%1</table>"
           "<p>MIT licence. Linked libraries keep their own licences:<br>Qt and Qwt LGPL, "
           "OpenSceneGraph OSGPL, OpenEXR BSD, SQLite public domain%2.</p>")
            .arg(table, irsg::hasScattering()
                            ? tr("; scattering loads FFTW, GPL, whose terms hold for the whole")
                            : QString()),
        this);
    label->setObjectName("aboutText");
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    lay(*this, label);
}

ShortcutsDialog::ShortcutsDialog(const QMenuBar& menus, const QList<QAction*>& ofResults,
                                 QWidget* parent)
    : QDialog(parent) {
    setObjectName("shortcutsDialog");
    setWindowTitle(tr("Keys and mouse"));
    // The keys of each menu, from its actions, so that the list is never wrong.
    QString keys;
    for (const auto* menu : menus.actions()) {
        const QString rows = keyRows(menu->menu()->actions());
        if (!rows.isEmpty())
            keys += heading(withoutMarks(menu->text())) + rows;
    }
    keys += heading(tr("Results")) + keyRows(ofResults);
    const QString mouse =
        heading(tr("Running analysis")) + row("Esc", tr("Cancel it and keep what is finished")) +
        heading(tr("3-D view")) +
        row(tr("Drag, arrow keys"), tr("Look around; arrows with Shift in steps of 1°")) +
        row(tr("Right drag, Shift and drag"), tr("Shift the picture")) +
        row(tr("Wheel, Page up, Page down"), tr("Move closer, move away")) +
        row(tr("Double click, Home"), tr("Fit the whole scene")) +
        row(tr("The same with Ctrl"), tr("Move the sensor of the project")) +
        row(tr("Click, again"), tr("Pick a face; the one behind it")) +
        heading(tr("Plots and images")) + row(tr("Wheel"), tr("Zoom at the cursor")) +
        row(tr("Drag"), tr("Zoom into a rectangle; statistics of it in an image")) +
        row(tr("Right drag"), tr("Move")) + row(tr("Double click"), tr("Show all")) +
        row(tr("Backspace"), tr("Take a zoom back (plots)")) +
        row(tr("Click in the legend"), tr("Hide or show a curve")) + heading(tr("Everywhere")) +
        row(tr("Alt and a letter"), tr("Menus and fields by their underlined letter")) +
        row(tr("Tab, Shift+Tab"), tr("From field to field"));
    QString images = heading(tr("Images"));
    for (const auto& [hint, what] : imageKeys())
        images += row(hint, what);
    images += heading(tr("Comparing images"));
    for (const auto& [hint, what] : comparisonKeys())
        images += row(hint, what);
    auto* tabs = new QTabWidget(this);
    tabs->setDocumentMode(true);
    const auto add = [&](const QString& title, const QString& name, const QString& rows) {
        auto* label = new QLabel("<table>" + rows + "</table>");
        label->setObjectName(name);
        label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
        tabs->addTab(new VerticalScrollArea(label, tabs), title);
    };
    add(tr("Menus and results"), "keyList", keys);
    add(tr("View, plots and mouse"), "mouseList", mouse);
    add(tr("Images"), "imageList", images);
    lay(*this, tabs);
    resize(sizeHint().expandedTo({560, 680}));
}

} // namespace smat::gui

#include "moc_HelpDialogs.cpp"
