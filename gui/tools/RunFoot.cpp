#include "gui/tools/RunFoot.h"

#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/widgets/VerticalScrollArea.h"

namespace smat::gui {

RunFoot::RunFoot(const QString& whatCancelDoes, QWidget* parent)
    : QWidget(parent),
      problem(new QLabel(this)),
      run(new QPushButton(tr("Run"), this)),
      cancel(new QPushButton(tr("Cancel"), this)),
      progress(new QProgressBar(this)),
      command(new QLineEdit(this)),
      unsaved(new QLabel(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 4, 10, 10);
    problem->setObjectName("problem");
    problem->setWordWrap(true);
    problem->hide();
    column->addWidget(problem);
    auto* buttons = new QHBoxLayout;
    run->setObjectName("run");
    run->setDefault(true);
    cancel->setObjectName("cancel");
    cancel->setToolTip(whatCancelDoes);
    buttons->addWidget(run, 1);
    buttons->addWidget(cancel, 1);
    column->addLayout(buttons);
    progress->setObjectName("progress");
    progress->setRange(0, 1000);
    column->addWidget(progress);
    column->addWidget(new QLabel(tr("Equivalent command:"), this));
    command->setObjectName("command");
    command->setReadOnly(true);
    column->addWidget(command);
    unsaved->setObjectName("unsavedNote");
    unsaved->setWordWrap(true);
    unsaved->hide();
    column->addWidget(unsaved);
}

QWidget* RunFoot::below(QWidget* form, RunFoot* foot, QWidget* parent) {
    auto* side = new QWidget(parent);
    side->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    auto* all = new QVBoxLayout(side);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    all->addWidget(new VerticalScrollArea(form, side), 1);
    all->addWidget(foot);
    return side;
}

} // namespace smat::gui

#include "moc_RunFoot.cpp"
