#include "gui/atmosphere/ImportAtmosphereDialog.h"

#include <algorithm>
#include <span>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

namespace fs = std::filesystem;

struct FileReading {
    fs::path file;
    qsizetype runs = 0;
    QStringList words; ///< warnings, or what is wrong
    bool isRead = false;
};

FileReading readOne(const fs::path& file) {
    FileReading one{.file = file, .runs = 0, .words = {}, .isRead = false};
    try {
        const auto table = irsg::TabulatedAtmosphere::import(std::span(&file, 1));
        one.isRead = true;
        one.runs = static_cast<qsizetype>(table.runs().size());
        for (const std::string& warning : table.warnings())
            one.words << textOf(warning);
    } catch (const irsg::InputError& error) {
        one.words = sentencesOf(error);
    }
    return one;
}

} // namespace

struct ImportAtmosphereDialog::Reading {
    std::vector<FileReading> files;
    std::shared_ptr<const irsg::TabulatedAtmosphere> family;
    QStringList problems; ///< of the family
};

ImportAtmosphereDialog::ImportAtmosphereDialog(Workbench& workbench, Dialogs dialogs,
                                               QWidget* parent)
    : QDialog(parent), workbench_(workbench), dialogs_(std::move(dialogs)) {
    setObjectName("importAirDialog");
    setWindowTitle(tr("Import MODTRAN results"));
    resize(720, 520);
    auto* words = new QLabel(tr("One run, or a family of runs of the same atmosphere on the same "
                                "wavenumbers: tape7, CSV or JSON, or tables of our own."),
                             this);
    words->setWordWrap(true);
    list_ = new QTreeWidget(this);
    list_->setObjectName("importedFiles");
    list_->setAccessibleName(tr("Files"));
    list_->setRootIsDecorated(false);
    list_->setHeaderLabels({tr("File"), tr("Runs"), tr("Notes")});
    list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    list_->setWordWrap(true);
    words_ = new QLabel(this);
    words_->setObjectName("importedFamily");
    words_->setWordWrap(true);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words_->setFocusPolicy(Qt::NoFocus);
    words_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    words_->setContentsMargins(2, 2, 2, 2);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(words_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* row = new QHBoxLayout;
    const auto button = [&](const char* name, const QString& text, const QString& tip,
                            void (ImportAtmosphereDialog::*does)()) {
        auto* made = new QPushButton(text, this);
        made->setObjectName(name);
        made->setToolTip(tip);
        made->setAutoDefault(false);
        connect(made, &QPushButton::clicked, this, does);
        row->addWidget(made);
        return made;
    };
    button("addRun", tr("Add a file…"), tr("Results of one or several runs"),
           &ImportAtmosphereDialog::addFile);
    button("addRuns", tr("Add a folder…"), tr("All results in a folder"),
           &ImportAtmosphereDialog::addFolder);
    remove_ = button("removeRun", tr("Remove"), tr("Take this file from the list"),
                     &ImportAtmosphereDialog::removeFile);
    row->addStretch(1);
    use_ = new QCheckBox(tr("Put it first among the atmospheres of the project"), this);
    use_->setObjectName("useTable");
    use_->setEnabled(workbench_.hasProject());
    use_->setChecked(workbench_.hasProject());
    auto* buttons = new QDialogButtonBox(this);
    buttons->addButton(tr("&Close"), QDialogButtonBox::RejectRole)->setObjectName("close");
    save_ = buttons->addButton(tr("&Save the table…"), QDialogButtonBox::ActionRole);
    save_->setObjectName("saveTable");
    connect(save_, &QPushButton::clicked, this, &ImportAtmosphereDialog::save);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(list_, &QTreeWidget::itemSelectionChanged, this,
            &ImportAtmosphereDialog::refreshButtons);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 14, 16, 12);
    column->setSpacing(10);
    column->addWidget(words);
    column->addWidget(list_, 3);
    column->addLayout(row);
    column->addWidget(scroll, 2);
    column->addWidget(use_);
    column->addWidget(buttons);
    read();
}

void ImportAtmosphereDialog::add(const std::vector<fs::path>& files) {
    for (const fs::path& file : files)
        if (std::ranges::find(files_, file) == files_.end())
            files_.push_back(file);
    read();
}

void ImportAtmosphereDialog::addFile() {
    const QString file = dialogs_.openFile(
        this, tr("MODTRAN results"),
        {tr("Results (*tape7* *.fl7 *.tp7 *.scn *.csv *.json *.smatatm)"), tr("All files (*)")});
    if (!file.isEmpty())
        add({file.toStdString()});
}

void ImportAtmosphereDialog::addFolder() {
    const QString folder = dialogs_.chooseFolder(this, tr("Folder with MODTRAN results"), {});
    if (folder.isEmpty())
        return;
    std::vector<fs::path> found;
    std::error_code failure;
    for (const auto& entry : fs::directory_iterator(folder.toStdString(), failure)) {
        try {
            if (entry.is_regular_file() && irsg::TabulatedAtmosphere::canImport(entry.path()))
                found.push_back(entry.path());
        } catch (const irsg::InputError&) {
            // What cannot be looked into is none.
        }
    }
    std::ranges::sort(found);
    if (found.empty())
        dialogs_.tell(this, tr("Nothing to import"),
                      {tr("There are no MODTRAN results in %1.").arg(folder)});
    add(found);
}

void ImportAtmosphereDialog::removeFile() {
    const int row = list_->indexOfTopLevelItem(list_->currentItem());
    if (row < 0)
        return;
    files_.erase(files_.begin() + row);
    read();
}

void ImportAtmosphereDialog::read() {
    family_.reset();
    refreshButtons();
    if (files_.empty()) {
        task_.cancel();
        return showReading({});
    }
    words_->setText(tr("Reading…"));
    task_.run<Reading>(
        [files = files_] {
            Reading reading;
            for (const fs::path& file : files)
                reading.files.push_back(readOne(file));
            if (!std::ranges::all_of(reading.files, &FileReading::isRead))
                return reading;
            try {
                reading.family = std::make_shared<const irsg::TabulatedAtmosphere>(
                    irsg::TabulatedAtmosphere::import(files));
            } catch (const irsg::InputError& error) {
                reading.problems = sentencesOf(error);
            }
            return reading;
        },
        [this](const Reading& reading) { showReading(reading); });
}

void ImportAtmosphereDialog::showReading(const Reading& reading) {
    const int row = list_->indexOfTopLevelItem(list_->currentItem());
    list_->clear();
    for (const FileReading& file : reading.files) {
        auto* item = new QTreeWidgetItem(list_, {textOf(file.file.filename()),
                                                 file.isRead ? QString::number(file.runs) : "–",
                                                 file.words.join('\n')});
        item->setToolTip(0, textOf(file.file));
        item->setToolTip(2, file.words.join('\n'));
        item->setIcon(0, icon(file.isRead ? "table" : "error"));
    }
    if (list_->topLevelItemCount() > 0)
        list_->setCurrentItem(
            list_->topLevelItem(std::clamp(row, 0, list_->topLevelItemCount() - 1)));
    family_ = reading.family;
    QStringList words = reading.problems;
    if (family_ != nullptr) {
        const irsg::SpectralRange base = family_->base();
        const auto runs = family_->runs().size();
        words << tr("%1, %2 to %3 µm")
                     .arg(runs == 1 ? tr("1 run") : tr("%1 runs").arg(runs))
                     .arg(formattedNumber(base.min_um), formattedNumber(base.max_um));
        for (const std::string& span : family_->spans())
            words << withFormattedUnits(textOf(span));
    } else if (reading.files.empty()) {
        words << tr("Add the results that are to become a table.");
    } else if (reading.problems.isEmpty()) {
        words << tr("Remove what cannot be read: a table is made of whole files.");
        for (const FileReading& file : reading.files)
            if (!file.isRead)
                words << file.words;
    }
    words_->setText(words.join('\n'));
    refreshButtons();
}

void ImportAtmosphereDialog::save() {
    const QString chosen = dialogs_.saveFile(
        this, tr("Save the table"), {tr("Tabulated atmospheres (*.smatatm)")}, "modtran.smatatm");
    if (chosen.isEmpty() || family_ == nullptr)
        return;
    try {
        const fs::path file = chosen.toStdString();
        family_->write(file);
        words_->setText(tr("Saved %1").arg(chosen));
        if (!use_->isChecked() || !workbench_.hasProject())
            return;
        const std::string before = workbench_.settings().text(key::environmentAtmospheres);
        Settings changed = workbench_.settings();
        changed.set(key::environmentAtmospheres,
                    file.string() + (before == "none" || before.empty() ? "" : ";" + before));
        workbench_.set(changed, tr("Use imported atmosphere"));
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("This table cannot be saved"), sentencesOf(error));
    }
}

void ImportAtmosphereDialog::refreshButtons() {
    remove_->setEnabled(list_->currentItem() != nullptr);
    save_->setEnabled(family_ != nullptr);
}

} // namespace smat::gui

#include "moc_ImportAtmosphereDialog.cpp"
