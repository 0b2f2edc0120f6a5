#include "gui/view/LoadingBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "gui/Theme.h"
#include "gui/Widgets.h"
#include "gui/view/SceneLoader.h"

namespace smat::gui {

LoadingBar::LoadingBar(SceneLoader& loader, QWidget* parent) : QWidget(parent) {
    setObjectName("loadingBar");
    auto* words = new QLabel(this);
    words->setObjectName("loadingWords");
    auto* busy = new QProgressBar(this);
    busy->setObjectName("loadingBusy");
    busy->setRange(0, 0);
    busy->setTextVisible(false);
    busy->setFixedSize(110, 12);
    auto* cancel = textButton(tr("Cancel"), "cancelLoading", tr("Leave the model unread"));
    cancel->setAutoRaise(true);
    cancel->setIcon(icon("cancel"));
    cancel->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    for (QWidget* widget :
         {static_cast<QWidget*>(words), static_cast<QWidget*>(busy), static_cast<QWidget*>(cancel)})
        row->addWidget(widget);
    hide();
    connect(cancel, &QToolButton::clicked, &loader, &SceneLoader::cancel);
    connect(&loader, &SceneLoader::waiting, this, [this, words](const QString& sentence) {
        words->setText(sentence);
        setVisible(!sentence.isEmpty());
    });
}

} // namespace smat::gui
