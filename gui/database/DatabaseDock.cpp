#include "gui/database/DatabaseDock.h"

#include <algorithm>

#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/database/CopyEntriesDialog.h"
#include "gui/database/DatabaseBanner.h"
#include "gui/database/EntryList.h"
#include "gui/database/FindingsPanel.h"
#include "gui/database/ImportMaterialDialog.h"
#include "gui/database/ImportSpectrumDialog.h"
#include "gui/database/MaterialPanel.h"
#include "gui/database/SpectrumPanel.h"
#include "gui/database/TemperaturePanel.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/Widgets.h"
#include "irsg/signature/MaterialLibrary.h"
#include "irsg/signature/SpectrumCsv.h"

namespace smat::gui {
namespace {

constexpr int findingsTab = 3;
constexpr int leastWidth_px = 392;
/// From here on the entry stands beside the list, not below it.
constexpr int sideBySide_px = 820;

} // namespace

DatabaseDock::DatabaseDock(Workbench& workbench, const Dialogs& dialogs, QWidget* window)
    : QDockWidget(tr("Database"), window),
      context_(workbench, workbench.database(), dialogs),
      files_(context_) {
    setObjectName("databaseDock");
    context_.window = window;
    toggleViewAction()->setText(tr("Signature database")); // a tab has less room than a menu
    // From the dock to its pages: a widget that gets another parent is polished anew with all that
    // is in it.
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    auto* body = new QWidget(scroll);
    scroll->setWidget(body);
    setWidget(scroll);
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(10, 8, 10, 10);
    column->setSpacing(8);
    body->setMinimumWidth(leastWidth_px);
    banner_ = new DatabaseBanner(context_, body);
    tabs_ = new QTabWidget(body);
    tabs_->setObjectName("databaseTabs");
    tabs_->setDocumentMode(true);
    tabs_->setIconSize(QSize(16, 16));
    tabs_->setStyleSheet("QTabBar::tab { padding: 7px 5px; }");
    temperature_ = new TemperaturePanel(context_, tabs_);
    auto* material = new MaterialPanel(context_, tabs_);
    connect(material, &MaterialPanel::importWanted, this,
            [this](int index) { importMaterialInto(index); });
    addPage(EntryKind::material, material, tr("Material"));
    addPage(EntryKind::temperature, temperature_, tr("Temperature"));
    addPage(EntryKind::spectrum, new SpectrumPanel(context_, tabs_), tr("Spectrum"));
    findings_ = new FindingsPanel(context_, tabs_);
    tabs_->addTab(findings_, icon("check-physics"), tr("Findings"));
    letShownPageAloneAskForRoom(*tabs_);

    auto* materials = pageOf(EntryKind::material).list;
    connect(materials->addButton("library", "addFromLibrary",
                                 tr("Add common materials and paints from the library")),
            &QToolButton::clicked, this, &DatabaseDock::addFromLibrary);
    connect(materials->addButton("import", "importMaterial", tr("Import a material from CSV")),
            &QToolButton::clicked, this, &DatabaseDock::importMaterial);
    auto* spectra = pageOf(EntryKind::spectrum).list;
    connect(spectra->addButton("import", "importSpectrum", tr("Import a spectrum from CSV")),
            &QToolButton::clicked, this, &DatabaseDock::importSpectrum);
    connect(spectra->addButton("export", "exportSpectrum", tr("Write this spectrum to CSV")),
            &QToolButton::clicked, this, &DatabaseDock::exportSpectrum);

    empty_ = new QLabel(tr("Temperatures, materials and spectra of a model's faces.\n"
                           "Open a project or a model to edit them."),
                        body);
    empty_->setObjectName("databaseEmpty");
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);

    column->addWidget(makeHeader());
    column->addWidget(banner_);
    column->addWidget(tabs_, 1);
    column->addWidget(empty_, 1);
    column->addStretch(0);
    // Behind another dock it takes no room from the view; in front it is as wide as it needs, but
    // in a window that is narrower than that it scrolls.
    connect(this, &QDockWidget::visibilityChanged, scroll, [scroll, body, window](bool inFront) {
        constexpr int ofOthers_px = 610; // the view and the docks on its left at least
        const int bar = scroll->verticalScrollBar()->sizeHint().width();
        const int room = std::max(window->width() - ofOthers_px, 0);
        scroll->setMinimumWidth(inFront ? std::min(body->minimumWidth() + bar, room) : 0);
    });

    connect(&context_.session(), &DatabaseSession::stateChanged, this, &DatabaseDock::refresh);
    connect(&context_.session(), &DatabaseSession::opened, this, &DatabaseDock::refresh);
    connect(&workbench, &Workbench::modelChosen, this, &DatabaseDock::refresh);
    connect(&workbench, &Workbench::projectChanged, this, &DatabaseDock::refresh);
    connect(&workbench, &Workbench::projectOpened, this, &DatabaseDock::refresh);
    connect(banner_, &DatabaseBanner::newRequested, this, [this] { files_.makeNew(); });
    connect(banner_, &DatabaseBanner::firstSignatureRequested, this,
            &DatabaseDock::firstSignatureWanted);
    connect(banner_, &DatabaseBanner::openRequested, this, [this] { files_.open(); });
    connect(banner_, &DatabaseBanner::saveAsRequested, this, [this] { files_.saveAs(); });
    connect(banner_, &DatabaseBanner::overwriteRequested, this, [this] { files_.overwrite(); });
    connect(tabs_, &QTabWidget::currentChanged, this, [this] {
        context_.session().endGesture();
        emit currentChanged(current());
    });
    connect(temperature_, &TemperaturePanel::spectrumRequested, this, [this](const QString& name) {
        select({EntryKind::spectrum, 0, name.toStdString()});
    });
    connect(findings_, &FindingsPanel::placeRequested, this, [this](const QString& place) {
        if (!context_.session().isOpen())
            return;
        if (const auto key = entryAt(context_.session().value(), place.toStdString()))
            select(*key);
    });
    const auto countFindings = [this] {
        const int count = findings_->errors() + findings_->warnings();
        tabs_->setTabText(findingsTab,
                          count == 0 ? tr("Findings") : tr("Findings (%1)").arg(count));
        tabs_->setTabIcon(findingsTab, icon(findings_->errors() > 0 ? "error"
                                            : count > 0             ? "warning"
                                                                    : "check-physics"));
    };
    connect(findings_, &FindingsPanel::countsChanged, this, countFindings);
    countFindings();
    refresh();
}

void DatabaseDock::addPage(EntryKind kind, EntryPanel* panel, const QString& title) {
    auto* page = new QWidget(tabs_);
    tabs_->addTab(page, title);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 8, 0, 0);
    auto* split = new QSplitter(Qt::Vertical, page);
    split->setChildrenCollapsible(false);
    auto* list = new EntryList(context_, kind, split);
    list->setObjectName(QStringLiteral("list%1").arg(static_cast<int>(kind)));
    split->addWidget(list);
    split->addWidget(panel);
    split->setStretchFactor(0, 2);
    split->setStretchFactor(1, 5);
    split->setSizes({230, 420});
    column->addWidget(split, 1);
    pageOf(kind) = {list, panel, split};
    connect(list, &EntryList::currentChanged, this, [this, list, panel] {
        panel->show(list->current());
        emit currentChanged(current());
    });
    panel->show(list->current());
}

QWidget* DatabaseDock::makeHeader() {
    auto* holder = new QWidget(this);
    title_ = new QLabel(holder);
    title_->setObjectName("databaseTitle");
    QFont font = title_->font();
    font.setBold(true);
    font.setPointSizeF(font.pointSizeF() * 1.1);
    title_->setFont(font);
    save_ = new QToolButton(holder);
    save_->setObjectName("saveDatabaseButton");
    save_->setIcon(icon("save"));
    save_->setText(tr("Save"));
    save_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    save_->setToolTip(tr("Save the signature database (Ctrl+Shift+D)"));
    connect(save_, &QToolButton::clicked, this, [this] { files_.save(); });
    auto* more = new QToolButton(holder);
    more->setObjectName("databaseMenu");
    more->setIcon(icon("menu"));
    more->setToolTip(tr("More for this database"));
    more->setAutoRaise(true);
    more->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(more);
    const auto action = [&](const QString& picture, const QString& text, const QString& name,
                            auto slot) {
        menu->addAction(icon(picture), text, this, slot)->setObjectName(name);
    };
    action("library", tr("Add from library…"), "menuLibrary", &DatabaseDock::addFromLibrary);
    action("database", tr("Copy from another database…"), "copyFromDatabase",
           &DatabaseDock::copyFromDatabase);
    action("import", tr("Import material…"), "menuImportMaterial", &DatabaseDock::importMaterial);
    action("import", tr("Import spectrum…"), "menuImportSpectrum", &DatabaseDock::importSpectrum);
    menu->addSeparator();
    action("new", tr("New database for this model…"), "menuNewDatabase",
           [this] { files_.makeNew(); });
    action("open", tr("Open another database…"), "menuOpenDatabase", [this] { files_.open(); });
    action("save", tr("Save as…"), "menuSaveDatabaseAs", [this] { files_.saveAs(); });
    more->setMenu(menu);
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(title_, 1);
    row->addWidget(save_);
    row->addWidget(more);
    return holder;
}

void DatabaseDock::refresh() {
    const auto& session = context_.session();
    tabs_->setVisible(session.isOpen());
    // Where there is a project, the banner says what can be done.
    empty_->setVisible(!session.isOpen() && !context_.workbench().hasProject());
    save_->setEnabled(session.isOpen() && session.isDirty() &&
                      session.access() == DatabaseSession::Access::edit);
    findChild<QToolButton*>("databaseMenu")->setEnabled(context_.workbench().hasProject());
    QString title = !session.isOpen() ? tr("No database")
                                      : QString::fromStdString(session.file().filename().string()) +
                                            (session.isDirty() ? " *" : "");
    const Workbench& workbench = context_.workbench();
    if (workbench.hasProject() && workbench.project().models.size() > 1)
        title = tr("%1 of %2")
                    .arg(title,
                         QString::fromStdString(
                             workbench.project().models.at(workbench.chosenModel()).shownName()));
    title_->setText(title);
    title_->setToolTip(QString::fromStdString(session.file().string()));
}

std::optional<EntryKey> DatabaseDock::current() const {
    const int tab = tabs_->currentIndex();
    return tab < 0 || tab >= findingsTab ? std::nullopt
                                         : pages_[static_cast<std::size_t>(tab)].list->current();
}

void DatabaseDock::select(const EntryKey& key) {
    tabs_->setCurrentIndex(static_cast<int>(key.kind));
    pageOf(key.kind).list->select(key);
}

void DatabaseDock::selectCodes(int temperature, int material) {
    pageOf(EntryKind::temperature).list->select({EntryKind::temperature, temperature});
    pageOf(EntryKind::material).list->select({EntryKind::material, material});
}

void DatabaseDock::takeEntries(irsg::SignatureDatabase source, const QString& title,
                               const QString& step) {
    CopyEntriesDialog dialog(context_, std::move(source), title, context_.window);
    if (!context_.dialogs().run(dialog))
        return;
    const auto copies = dialog.copies();
    if (copies.empty())
        return;
    context_.session().edit(
        step, [&](irsg::SignatureDatabase& into) { copyEntries(dialog.source(), copies, into); });
    select(copies.back().to);
}

void DatabaseDock::addFromLibrary() {
    if (context_.session().isOpen())
        takeEntries(irsg::materialLibrary(), tr("Library of materials and paints"),
                    tr("Add materials from the library"));
}

void DatabaseDock::copyFromDatabase() {
    if (!context_.session().isOpen())
        return;
    const QString file = context_.dialogs().openFile(
        context_.window, tr("Copy from a signature database"), databaseFilters());
    if (file.isEmpty())
        return;
    context_.attempt(tr("This database cannot be opened"), [&] {
        const std::filesystem::path path = file.toStdString();
        const QString name = QString::fromStdString(path.filename().string());
        takeEntries(irsg::loadSignatureFile(path, irsg::OutsideChanges::accept).database,
                    tr("Copy from %1").arg(name), tr("Copy entries from %1").arg(name));
    });
}

void DatabaseDock::importMaterial() {
    importMaterialInto({});
}

void DatabaseDock::importMaterialInto(std::optional<int> wanted) {
    if (!context_.session().isOpen())
        return;
    const QString file = context_.dialogs().openFile(
        context_.window, tr("Import a material"),
        {tr("Tables and spectra of libraries (*.csv *.txt *.bsdf *.asc *.jdx *.dx *.yml "
            "*.ems)"),
         tr("All files (*)")});
    if (file.isEmpty())
        return;
    ImportMaterialDialog dialog(context_, file.toStdString(), wanted, context_.window);
    if (!context_.dialogs().run(dialog) || !dialog.material())
        return;
    const int index = dialog.index();
    const irsg::Material material = *dialog.material();
    context_.session().edit(
        tr("Import material %1").arg(index),
        [&](irsg::SignatureDatabase& database) { database.materials[index] = material; });
    select({EntryKind::material, index});
}

void DatabaseDock::importSpectrum() {
    if (!context_.session().isOpen())
        return;
    const QString file =
        context_.dialogs().openFile(context_.window, tr("Import a spectrum"),
                                    {tr("Tables (*.csv *.txt)"), tr("All files (*)")});
    if (file.isEmpty())
        return;
    ImportSpectrumDialog dialog(context_, file.toStdString(), context_.window);
    if (!context_.dialogs().run(dialog) || !dialog.spectrum())
        return;
    const irsg::UserSpectrum spectrum = *dialog.spectrum();
    context_.session().edit(
        tr("Import spectrum %1").arg(QString::fromStdString(spectrum.name)),
        [&](irsg::SignatureDatabase& database) { database.spectra[spectrum.name] = spectrum; });
    select({EntryKind::spectrum, 0, spectrum.name});
}

void DatabaseDock::exportSpectrum() {
    const auto key = pageOf(EntryKind::spectrum).list->current();
    if (!key)
        return;
    const QString file =
        context_.dialogs().saveFile(context_.window, tr("Write a spectrum"), {tr("Tables (*.csv)")},
                                    QString::fromStdString(key->name + ".csv"));
    if (!file.isEmpty())
        context_.attempt(tr("This spectrum cannot be written"), [&] {
            irsg::writeSpectrumCsv(context_.session().value().spectra.at(key->name),
                                   file.toStdString());
        });
}

void DatabaseDock::resizeEvent(QResizeEvent* event) {
    QDockWidget::resizeEvent(event);
    for (const auto& page : pages_)
        page.split->setOrientation(width() >= sideBySide_px ? Qt::Horizontal : Qt::Vertical);
}

} // namespace smat::gui

#include "moc_DatabaseDock.cpp"
