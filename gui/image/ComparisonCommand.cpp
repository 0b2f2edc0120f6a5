#include "gui/image/ComparisonCommand.h"

#include <QClipboard>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/widgets/Widgets.h"

namespace smat::gui {

ComparisonCommand::ComparisonCommand(QWidget* parent) : QWidget(parent) {
    words_ = new QLabel(this);
    words_->setObjectName("commandWords");
    words_->setWordWrap(true);
    words_->setForegroundRole(QPalette::PlaceholderText);
    line_ = new QLineEdit(this);
    line_->setObjectName("commandLine");
    line_->setReadOnly(true);
    line_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    copy_ = textButton(tr("Copy"), "copyCommand", tr("Copy the command line"));
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(line_, 1);
    row->addWidget(copy_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 0, 8, 8);
    column->setSpacing(4);
    column->addWidget(words_);
    column->addLayout(row);
    connect(copy_, &QToolButton::clicked, this, &ComparisonCommand::copy);
}

void ComparisonCommand::setCommand(const QString& command) {
    const bool isThere = !command.isEmpty();
    words_->setText(isThere ? tr("Equivalent command")
                            : tr("Equivalent command: save each result as .exr first, then "
                                 "compare them again."));
    line_->setText(command);
    line_->setToolTip(command);
    line_->setCursorPosition(0);
    line_->setVisible(isThere);
    copy_->setVisible(isThere);
}

void ComparisonCommand::copy() const {
    if (!line_->text().isEmpty())
        QGuiApplication::clipboard()->setText(line_->text());
}

} // namespace smat::gui

#include "moc_ComparisonCommand.cpp"
