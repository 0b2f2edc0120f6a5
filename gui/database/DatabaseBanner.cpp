#include "gui/database/DatabaseBanner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/ThemeColors.h"
#include "irsg/core/Errors.h"

namespace smat::gui {

DatabaseBanner::DatabaseBanner(EditorContext& context, QWidget* parent)
    : QFrame(parent), context_(context) {
    setObjectName("databaseBanner");
    words_ = new QLabel(this);
    words_->setObjectName("bannerText");
    words_->setWordWrap(true);
    buttons_ = new QHBoxLayout;
    buttons_->setSpacing(6);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 9, 12, 9);
    column->setSpacing(8);
    column->addWidget(words_);
    column->addLayout(buttons_);
    auto& session = context_.session();
    connect(&session, &DatabaseSession::stateChanged, this, &DatabaseBanner::refresh);
    connect(&session, &DatabaseSession::opened, this, [this] {
        changedOnDisk_ = false;
        refresh();
    });
    connect(&session, &DatabaseSession::changedOnDisk, this, [this] {
        // Nothing is lost by taking the new content where nothing was edited.
        changedOnDisk_ = true;
        if (!context_.session().isDirty())
            attempt([this] { context_.session().reload(); });
        refresh();
    });
    connect(&context_.workbench(), &Workbench::projectOpened, this, &DatabaseBanner::refresh);
    connect(&context_.workbench(), &Workbench::projectChanged, this, &DatabaseBanner::refresh);
    connect(&context_.workbench(), &Workbench::modelChosen, this, &DatabaseBanner::refresh);
    refresh();
}

QString DatabaseBanner::text() const {
    return isHidden() ? QString() : words_->text();
}

void DatabaseBanner::attempt(const std::function<void()>& act) {
    try {
        act();
    } catch (const irsg::InputError& error) {
        context_.dialogs().tell(context_.window, tr("The signature database"), sentencesOf(error));
    }
    refresh();
}

void DatabaseBanner::say(const QString& text) {
    setStyleSheet(
        QStringLiteral("#databaseBanner { background: %1; border: 1px solid %2;"
                       " border-radius: 6px; }")
            .arg(colors::notice(palette()).name(), colors::noticeFrame(palette()).name()));
    words_->setText(text);
    show();
}

template <typename Act>
void DatabaseBanner::offer(const QString& name, const QString& words, Act act) {
    auto* button = new QPushButton(words, this);
    button->setObjectName(name);
    connect(button, &QPushButton::clicked, this, act);
    buttons_->addWidget(button);
}

void DatabaseBanner::refresh() {
    while (auto* item = buttons_->takeAt(0)) {
        if (item->widget() != nullptr)
            item->widget()->deleteLater();
        delete item;
    }
    auto& session = context_.session();
    auto& workbench = context_.workbench();
    if (!workbench.hasProject()) {
        hide();
        return;
    }
    if (!session.isOpen()) {
        const QStringList problem = workbench.target().problem();
        say(problem.isEmpty() ? tr("This model has no signature database yet.")
                              : problem.join("\n"));
        if (workbench.target().canAcceptChanges())
            offer("acceptChanges", tr("Accept these changes"),
                  [this] { attempt([this] { context_.workbench().target().acceptChanges(); }); });
        if (problem.isEmpty())
            offer("firstSignature", tr("From names…"), [this] { emit firstSignatureRequested(); });
        offer("newDatabase", tr("New database…"), [this] { emit newRequested(); });
        offer("chooseDatabase", tr("Open another…"), [this] { emit openRequested(); });
    } else if (const auto copies = session.recoveries(); copies > 0) {
        say(copies == 1 ? tr("A window that ended without saving left a copy of its edits.")
                        : tr("Windows that ended without saving left %1 copies of their edits. "
                             "This is about the newest; the others are offered after it.")
                              .arg(copies));
        offer("recover", tr("Recover them"),
              [this] { attempt([this] { context_.session().recover(); }); });
        offer("discardRecovery", tr("Discard them"),
              [this] { context_.session().discardRecovery(); });
    } else if (changedOnDisk_ && session.isChangedOnDisk()) {
        say(tr("Another program has changed this file since it was read."));
        offer("reload", tr("Take the file's version"),
              [this] { attempt([this] { context_.session().reload(); }); });
        offer("overwrite", tr("Replace it with mine"), [this] { emit overwriteRequested(); });
    } else if (session.access() != DatabaseSession::Access::edit) {
        say(session.accessNote());
        offer("bannerSaveAs", tr("Save as…"), [this] { emit saveAsRequested(); });
    } else if (!session.recoveryProblem().isEmpty()) {
        say(tr("Unsaved edits have no copy beside the file, and would be lost with this window: "
               "%1. Save them, or save them elsewhere.")
                .arg(session.recoveryProblem()));
        offer("bannerSaveAs", tr("Save as…"), [this] { emit saveAsRequested(); });
    } else {
        changedOnDisk_ = false;
        hide();
        return;
    }
    buttons_->addStretch(1);
}

} // namespace smat::gui

#include "moc_DatabaseBanner.cpp"
