#include "gui/project/ConvertModelDialog.h"

#include <atomic>
#include <stop_token>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFontDatabase>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/analysis/ResultStore.h"
#include "gui/project/PlacingFields.h"
#include "gui/project/ProjectFiles.h"
#include "gui/widgets/BackgroundPool.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "irsg/geometry/model/ModelConverter.h"

namespace smat::gui {
namespace {

QString reportText(const irsg::ConversionReport& report) {
    long read = 0, written = 0;
    for (const auto& [codes, count] : report.polygonsRead)
        read += count;
    for (const auto& [codes, count] : report.polygonsWritten)
        written += count;
    QString text = ConvertModelDialog::tr("Read      %1 polygons in %2 drawables\n"
                                          "Written   %3 polygons in %4 drawables\n\n"
                                          "Temperature  Material   Polygons read   written\n")
                       .arg(read)
                       .arg(report.drawablesRead)
                       .arg(written)
                       .arg(report.drawablesWritten);
    for (const auto& [codes, count] : report.polygonsWritten) {
        const auto before = report.polygonsRead.find(codes);
        text += QStringLiteral("%1%2%3%4\n")
                    .arg(codes.temperature, 11)
                    .arg(codes.material, 10)
                    .arg(before == report.polygonsRead.end() ? 0 : before->second, 16)
                    .arg(count, 10);
    }
    for (const auto& remark : report.remarks)
        text += "\n" + QString::fromStdString(remark);
    return text;
}

} // namespace

struct ConvertModelDialog::Work {
    std::atomic<bool> done = false;
    std::stop_source stop;
    irsg::ConversionReport report;
    QStringList problems;
};

ConvertModelDialog::ConvertModelDialog(Dialogs& dialogs, QWidget* parent)
    : QDialog(parent), dialogs_(dialogs) {
    setObjectName("convertModelDialog");
    setWindowTitle(tr("Import or convert a model"));
    resize(900, 520);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(10);
    input_ = addFile(grid, "input", tr("&Model to read"));
    output_ = addFile(grid, "output", tr("&File to write"));
    output_->setPlaceholderText(tr(".osgt, .osgb, .ive, .osg or .osgx"));
    openIt_ = new QCheckBox(tr("&Open what was written"), this);
    openIt_->setObjectName("openIt");
    openIt_->setChecked(true);
    grid->addWidget(openIt_, 2, 1);
    placing_ = new PlacingFields("convert", this, PlacingFields::Asks::axesAndUnit);
    placing_->setMinimumWidth(300);
    report_ = new QPlainTextEdit(this);
    report_->setObjectName("report");
    report_->setReadOnly(true);
    report_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    report_->setPlaceholderText(
        tr("The codes of temperature and material, visible colours, levels of detail and switches "
           "are kept; external references become part of the file. It is written in metres, with y "
           "to the nose and z up. What was written is read back and compared."));
    bar_ = new QProgressBar(this);
    bar_->setRange(0, 0);
    bar_->setTextVisible(false);
    elapsed_ = new QLabel(this);
    elapsed_->setObjectName("elapsed");
    elapsed_->setForegroundRole(QPalette::PlaceholderText);

    auto* buttons = new QDialogButtonBox(this);
    close_ = buttons->addButton(tr("&Close"), QDialogButtonBox::RejectRole);
    close_->setObjectName("close");
    convert_ = buttons->addButton(tr("Con&vert"), QDialogButtonBox::ActionRole);
    convert_->setObjectName("convert");
    convert_->setDefault(true);
    connect(convert_, &QPushButton::clicked, this, &ConvertModelDialog::start);
    connect(buttons, &QDialogButtonBox::rejected, this, &ConvertModelDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 14);
    column->setSpacing(12);
    column->addLayout(grid);
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    row->addWidget(placing_, 2);
    row->addWidget(report_, 3);
    column->addLayout(row, 1);
    column->addWidget(bar_);
    column->addWidget(elapsed_);
    column->addWidget(buttons);
    watch_.setInterval(50);
    connect(&watch_, &QTimer::timeout, this, [this] {
        tellElapsed();
        if (work_->done)
            onDone();
    });
    connect(input_, &QLineEdit::textChanged, this, [this](const QString& text) {
        const QString file = text.trimmed();
        placing_->setFile(QFileInfo(file).isFile() ? file.toStdString() : std::string());
        refresh();
    });
    connect(placing_, &PlacingFields::changed, this, &ConvertModelDialog::refresh);
    connect(output_, &QLineEdit::textChanged, this, &ConvertModelDialog::refresh);
    refresh();
}

ConvertModelDialog::~ConvertModelDialog() {
    if (isRunning())
        work_->stop.request_stop();
}

QLineEdit* ConvertModelDialog::addFile(QGridLayout* grid, const QString& name,
                                       const QString& label) {
    auto* edit = new QLineEdit(this);
    edit->setObjectName(name);
    auto* browse = new QToolButton(this);
    browse->setObjectName(name + ".browse");
    browse->setIcon(icon("open"));
    browse->setToolTip(tr("Choose a file"));
    connect(browse, &QToolButton::clicked, this, [this, name] {
        if (name == "input") {
            const QString file = dialogs_.openFile(
                this, tr("Model to read"), {ProjectFiles::modelFilter(), tr("All files (*)")});
            if (!file.isEmpty())
                setInput(file);
        } else {
            const QString file = dialogs_.saveFile(this, tr("File to write"),
                                                   {tr("OpenSceneGraph binary (*.osgb)"),
                                                    tr("OpenSceneGraph text (*.osgt)"),
                                                    tr("OpenSceneGraph IVE (*.ive)")},
                                                   output_->text());
            if (!file.isEmpty())
                output_->setText(file);
        }
    });
    auto* caption = new QLabel(label, this);
    caption->setBuddy(edit);
    const int row = grid->rowCount() - (name == "input" ? 1 : 0);
    grid->addWidget(caption, row, 0, Qt::AlignRight);
    grid->addWidget(edit, row, 1);
    grid->addWidget(browse, row, 2);
    return edit;
}

void ConvertModelDialog::setInput(const QString& file) {
    input_->setText(file);
    if (!output_->isModified()) {
        const QFileInfo info(file);
        output_->setText(info.path() + "/" + info.completeBaseName() +
                         (info.suffix() == "osgb" ? ".osgt" : ".osgb"));
    }
}

void ConvertModelDialog::start() {
    const QString out = output_->text().trimmed();
    if (QFileInfo::exists(out) && dialogs_.ask(this, tr("Replace a file"),
                                               tr("%1 exists.").arg(out), {tr("&Replace it")}) != 0)
        return;
    written_.clear();
    report_->clear();
    work_ = std::make_shared<Work>();
    backgroundPool().start([work = work_, in = input_->text().trimmed().toStdString(),
                            to = out.toStdString(), placing = placing_->placing()] {
        try {
            work->report = irsg::convertModel(in, to, work->stop.get_token(), {.placing = placing});
        } catch (const irsg::InputError& error) {
            work->problems = sentencesOf(error);
        } catch (const std::exception& error) {
            work->problems << tr("Internal error: %1").arg(error.what());
        }
        work->done = true;
    });
    clock_.start();
    watch_.start();
    tellElapsed();
    refresh();
}

void ConvertModelDialog::cancel() {
    watch_.stop();
    std::exchange(work_, nullptr)->stop.request_stop();
    report_->setPlainText(tr("Cancelled. No unfinished file is left."));
    refresh();
}

void ConvertModelDialog::reject() {
    if (isRunning())
        cancel();
    else
        done(fileToOpen().isEmpty() ? Rejected : Accepted);
}

void ConvertModelDialog::tellElapsed() {
    elapsed_->setText(
        tr("Converting, %1").arg(durationText(static_cast<double>(clock_.elapsed()) / 1000.0)));
}

void ConvertModelDialog::onDone() {
    watch_.stop();
    const auto work = std::exchange(work_, nullptr);
    if (work->problems.isEmpty()) {
        written_ = output_->text().trimmed();
        report_->setPlainText(reportText(work->report));
    } else {
        report_->setPlainText(work->problems.join("\n\n"));
    }
    refresh();
}

void ConvertModelDialog::refresh() {
    bar_->setVisible(isRunning());
    elapsed_->setVisible(isRunning());
    close_->setText(isRunning() ? tr("&Cancel") : tr("&Close"));
    for (auto* widget : std::initializer_list<QWidget*>{input_, output_, placing_})
        widget->setEnabled(!isRunning());
    convert_->setEnabled(!isRunning() && QFileInfo(input_->text().trimmed()).isFile() &&
                         !output_->text().trimmed().isEmpty() && placing_->isRight());
}

QString ConvertModelDialog::fileToOpen() const {
    return openIt_->isChecked() ? written_ : QString();
}

} // namespace smat::gui

#include "moc_ConvertModelDialog.cpp"
