#include "gui/view/LoadingBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "gui/widgets/Theme.h"
#include "gui/widgets/Widgets.h"

namespace smat::gui {

LoadingBar::LoadingBar(QWidget* parent) : QWidget(parent), words_(new QLabel(this)) {
    setObjectName("loadingBar");
    words_->setObjectName("loadingWords");
    auto* busy = new QProgressBar(this);
    busy->setObjectName("loadingBusy");
    busy->setRange(0, 0);
    busy->setTextVisible(false);
    busy->setFixedSize(110, 12);
    auto* cancel = textButton(tr("Cancel"), "cancelLoading", tr("Stop reading the model"));
    cancel->setAutoRaise(true);
    cancel->setIcon(icon("cancel"));
    cancel->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    for (QWidget* widget : std::initializer_list<QWidget*>{words_, busy, cancel})
        row->addWidget(widget);
    hide();
}

void LoadingBar::follow(ModelWait& wait) {
    connect(findChild<QToolButton*>("cancelLoading"), &QToolButton::clicked, &wait,
            &ModelWait::cancel);
    connect(&wait, &ModelWait::waiting, this, [this, &wait](const QString& sentence) {
        if (sentence.isEmpty() && told_ != &wait)
            return;
        told_ = &wait;
        words_->setText(sentence);
        setVisible(!sentence.isEmpty());
    });
}

} // namespace smat::gui

#include "moc_LoadingBar.cpp"
