#include "gui/widgets/Dialogs.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QStyle>

#include "gui/widgets/DialogFolders.h"
#include "gui/widgets/Theme.h"

namespace smat::gui {
namespace {

/// Adds the suffix of the chosen filter where the name has none, and the whole of one of two parts,
/// ".draws.csv", where it has but the last.
QString withSuffix(const QString& file, const QString& filter) {
    const auto match = QRegularExpression(R"(\*((?:\.\w+)?)(\.\w+))").match(filter);
    if (file.isEmpty() || !match.hasMatch())
        return file;
    const QString before = match.captured(1), last = match.captured(2);
    if (!before.isEmpty() && file.endsWith(last) && !file.endsWith(before + last))
        return file.chopped(last.size()) + before + last;
    return QFileInfo(file).suffix().isEmpty() ? file + before + last : file;
}

/// A box with one of our own pictures, which follow the theme.
void usePicture(QMessageBox& box, const QString& name) {
    const int size = box.style()->pixelMetric(QStyle::PM_MessageBoxIconSize, nullptr, &box);
    box.setIconPixmap(icon(name).pixmap(QSize(size, size), box.devicePixelRatioF()));
}

} // namespace

Dialogs Dialogs::ofDesktop() {
    Dialogs dialogs;
    dialogs.openFile = [](QWidget* parent, const QString& title, const QStringList& filters) {
        return remembered(title, QFileDialog::getOpenFileName(parent, title, lastFolder(title),
                                                              filters.join(";;")));
    };
    dialogs.saveFile = [](QWidget* parent, const QString& title, const QStringList& filters,
                          const QString& suggestion) {
        QString chosen;
        const QString file = QFileDialog::getSaveFileName(parent, title, startOf(title, suggestion),
                                                          filters.join(";;"), &chosen);
        return remembered(title, withSuffix(file, chosen));
    };
    dialogs.chooseFolder = [](QWidget* parent, const QString& title, const QString& suggestion) {
        const QString folder =
            QFileDialog::getExistingDirectory(parent, title, startOf(title, suggestion));
        // What lies in it is what is remembered of files.
        remembered(title, folder.isEmpty() ? folder : folder + "/.");
        return folder;
    };
    dialogs.tell = [](QWidget* parent, const QString& title, const QStringList& sentences) {
        QMessageBox box(QMessageBox::Warning, title, sentences.mid(0, 8).join("\n\n"),
                        QMessageBox::Ok, parent);
        usePicture(box, "warning");
        if (sentences.size() > 8)
            box.setDetailedText(sentences.join('\n'));
        box.exec();
    };
    dialogs.ask = [](QWidget* parent, const QString& title, const QString& question,
                     const QStringList& answers) {
        QMessageBox box(QMessageBox::Question, title, question, QMessageBox::NoButton, parent);
        usePicture(box, "question");
        QList<QAbstractButton*> buttons;
        for (const auto& answer : answers)
            buttons << box.addButton(answer, QMessageBox::ActionRole);
        // Escape and the frame of the box give no answer; so does this button.
        box.setDefaultButton(box.addButton(QMessageBox::Cancel));
        box.exec();
        return static_cast<int>(buttons.indexOf(box.clickedButton()));
    };
    dialogs.run = [](QDialog& dialog) {
        // With its title bar on a small screen, too, so that its buttons are in reach.
        constexpr QSize aroundIt_px(16, 56);
        if (dialog.testAttribute(Qt::WA_Resized))
            dialog.resize(dialog.size().boundedTo(dialog.screen()->availableSize() - aroundIt_px));
        return dialog.exec() == QDialog::Accepted;
    };
    return dialogs;
}

} // namespace smat::gui
