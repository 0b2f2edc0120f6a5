#include "gui/database/ImportDialog.h"

#include <utility>

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/ThemeColors.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Remarks.h"

namespace smat::gui {

namespace {

constexpr qsizetype mostLines = 8;

} // namespace

ImportDialog::ImportDialog(const EditorContext& context, std::filesystem::path file,
                           QWidget* parent)
    : QDialog(parent), context_(context), file_(std::move(file)) {
    setWindowTitle(tr("Import %1").arg(QString::fromStdString(file_.filename().string())));
}

void ImportDialog::start(QFormLayout* fields) {
    outcome_ = new QLabel(this);
    outcome_->setObjectName("outcome");
    outcome_->setWordWrap(true);
    outcome_->setMinimumSize(480, 120);
    outcome_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    outcome_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    buttons_ = okAndCancel(*this, tr("Import"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 14);
    column->setSpacing(12);
    column->addLayout(fields);
    column->addWidget(outcome_, 1);
    column->addWidget(buttons_);
    read();
}

void ImportDialog::read() {
    QString words;
    bool isRead = false;
    try {
        const irsg::CollectedRemarks remarks;
        words = readFile();
        for (const std::string& remark : remarks.sentences())
            words += "\n" + QString::fromStdString(remark);
        isRead = true;
    } catch (const irsg::InputError& error) {
        const QStringList sentences = sentencesOf(error);
        words = sentences.mid(0, mostLines).join("\n");
        if (sentences.size() > mostLines)
            words += "\n" + tr("… and %1 more").arg(sentences.size() - mostLines);
    }
    outcome_->setText(words);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(isRead);
    outcome_->setStyleSheet(
        isRead ? QString() : QStringLiteral("color: %1").arg(colors::errorText(palette()).name()));
}

} // namespace smat::gui

#include "moc_ImportDialog.cpp"
