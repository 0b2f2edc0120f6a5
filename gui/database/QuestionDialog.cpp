#include "gui/database/QuestionDialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace smat::gui {

QuestionDialog::QuestionDialog(const QString& title, const QString& text,
                               const QStringList& answers, QWidget* parent)
    : QDialog(parent) {
    setObjectName("questionDialog");
    setWindowTitle(title);
    auto* words = new QLabel(text, this);
    words->setObjectName("question");
    words->setWordWrap(true);
    words->setMinimumWidth(380);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    for (int i = 0; i < answers.size(); ++i) {
        auto* button = buttons->addButton(answers[i], QDialogButtonBox::ActionRole);
        button->setObjectName(QStringLiteral("answer%1").arg(i));
        button->setDefault(i == 0);
        connect(button, &QPushButton::clicked, this, [this, i] {
            answer_ = i;
            accept();
        });
    }
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 14);
    column->setSpacing(18);
    column->addWidget(words);
    column->addWidget(buttons);
}

} // namespace smat::gui

#include "moc_QuestionDialog.cpp"
