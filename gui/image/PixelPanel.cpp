#include "gui/image/PixelPanel.h"

#include <utility>

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Widgets.h"
#include "smatcore/analysis/PixelExplainer.h"

namespace smat::gui {

namespace {

enum PixelColumn { what = 0, factor = 1, light = 2, value = 3 };

QString pixelNumber(double number, int digits = 7) {
    return QString::number(number, 'g', digits);
}

/// A row that says one thing.
QTreeWidgetItem* addPixelRow(QTreeWidgetItem* parent, const QString& name, const QString& text) {
    auto* row = parent ? new QTreeWidgetItem(parent) : new QTreeWidgetItem;
    row->setText(what, name);
    row->setText(value, text);
    row->setTextAlignment(value, Qt::AlignRight | Qt::AlignVCenter);
    return row;
}

QTreeWidgetItem* addPixelRow(QTreeWidgetItem* parent, const QString& name, double number,
                             const QString& unit = {}) {
    return addPixelRow(parent, name, pixelNumber(number) + (unit.isEmpty() ? "" : " " + unit));
}

/// Rows over others, in bold, that are in no tree yet: one that shows them would measure all of
/// itself for each text.
struct PixelHeads {
    QFont bold;
    QList<QTreeWidgetItem*> all;

    QTreeWidgetItem* add(const QString& name, const QString& text) {
        auto* head = addPixelRow(nullptr, name, text);
        for (const PixelColumn column : {what, value})
            head->setFont(column, bold);
        all.append(head);
        return head;
    }
};

QString codeWords(int index, const std::string& name) {
    return name.empty() ? QString::number(index)
                        : QStringLiteral("%1 %2").arg(index).arg(QString::fromStdString(name));
}

void addPixelSurface(PixelHeads& heads, const irsg::ExplainedSurface& surface) {
    const auto tr = [](const char* text) { return PixelPanel::tr(text); };
    const QString name = QString::fromStdString(surface.object);
    auto* head = heads.add(
        (surface.lightAlone ? tr("Layer %1: %2, light through others") : tr("Layer %1: %2"))
            .arg(surface.layer)
            .arg(name),
        pixelNumber(surface.radiance_W_m2_sr));
    for (const irsg::ExplainedTerm& term : surface.terms) {
        auto* row = addPixelRow(head, QString::fromStdString(term.name), term.radiance_W_m2_sr);
        row->setText(factor, pixelNumber(term.factor));
        row->setText(light, term.light ? pixelNumber(*term.light) : QStringLiteral("–"));
        for (const PixelColumn column : {factor, light})
            row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        row->setToolTip(
            value, tr("%1 W·m⁻²·sr⁻¹ at a factor of 1").arg(pixelNumber(term.atFactorOne_W_m2_sr)));
    }
    if (surface.betweenSurfaces_W_m2_sr != 0.0)
        addPixelRow(head, tr("light of other surfaces"), surface.betweenSurfaces_W_m2_sr);
    if (surface.measuredSpectrum.empty())
        addPixelRow(
            head,
            tr("temperature %1").arg(codeWords(surface.temperatureIndex, surface.temperatureName)),
            surface.temperature_K, "K");
    else
        addPixelRow(head, tr("measured spectrum"),
                    QString::fromStdString(surface.measuredSpectrum));
    addPixelRow(head, tr("material %1").arg(codeWords(surface.materialIndex, surface.materialName)),
                tr("ε %1   ρ %2   τ %3")
                    .arg(pixelNumber(surface.emissivity, 5), pixelNumber(surface.reflectivity, 5),
                         pixelNumber(surface.transmissivity, 5)));
    if (surface.nAngleFactor != 0.0)
        addPixelRow(head, tr("N of cosᴺ"), surface.nAngleFactor);
    if (!surface.lightAlone) {
        addPixelRow(head, tr("share of the pixel"), surface.share);
        addPixelRow(head, tr("range"), surface.range_m, "m");
    }
    addPixelRow(head, tr("transmittance of the air"), surface.atmosphereTransmittance);
    for (const std::string& through : surface.throughMaterials)
        addPixelRow(head, tr("seen or lit through"), QString::fromStdString(through));
    if (!surface.throughMaterials.empty())
        addPixelRow(head, tr("transmittance of these"), surface.throughTransmittance);
    if (!surface.lightAlone)
        addPixelRow(head, tr("background that it hides"), surface.hidden_W_m2_sr);
}

QList<QTreeWidgetItem*> pixelHeads(QFont bold, const ExplainedPixel& pixel) {
    bold.setBold(true);
    PixelHeads heads{bold, {}};
    const auto tr = [](const char* text) { return PixelPanel::tr(text); };
    const irsg::PixelExplanation& of = pixel.computed;
    for (const irsg::ExplainedSurface& surface : of.surfaces)
        addPixelSurface(heads, surface);
    auto* background = heads.add(of.surfaces.empty() ? tr("Background alone") : tr("Background"),
                                 pixelNumber(of.backgroundLeft_W_m2_sr));
    const auto part = [&](const QString& name, const std::optional<double>& number) {
        if (number)
            addPixelRow(background, name, *number);
    };
    part(tr("sky pictures and the sun's disc"), of.sky_W_m2_sr);
    part(tr("terrain"), of.terrain_W_m2_sr);
    part(tr("the environment's"), of.environment_W_m2_sr);
    addPixelRow(background, tr("behind the pixel"), of.background_W_m2_sr);
    auto* sum = heads.add(tr("Computed"), pixelNumber(of.radiance_W_m2_sr));
    addPixelRow(sum, tr("rendered"), pixel.drawn_W_m2_sr);
    addPixelRow(sum, tr("difference"), pixel.difference_W_m2_sr());
    addPixelRow(sum, tr("relative difference"), pixel.relative());
    if (pixel.inImage_W_m2_sr) {
        addPixelRow(sum, tr("in the image"), *pixel.inImage_W_m2_sr);
        addPixelRow(sum, tr("rendered now, minus image"),
                    pixel.drawn_W_m2_sr - *pixel.inImage_W_m2_sr);
    }
    addPixelRow(sum, tr("rays through the pixel"), QString::number(of.samples));
    addPixelRow(sum, tr("3 × 3 pixels hit the same facet"), of.isInterior ? tr("yes") : tr("no"));
    return heads.all;
}

} // namespace

PixelPanel::PixelPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("pixelPanel");
    title_ = new QLabel(this);
    title_->setObjectName("pixelTitle");
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    copy_ = textButton(tr("Copy"), "copyExplanation",
                       tr("Copy all of it as text, as smat-batch explain prints it"));
    copy_->setEnabled(false);
    tree_ = new QTreeWidget(this);
    tree_->setObjectName("pixelTerms");
    tree_->setHeaderLabels({tr("What"), tr("Factor"), tr("Light"), tr("W·m⁻²·sr⁻¹")});
    tree_->headerItem()->setToolTip(
        light, tr("In the band: W·m⁻² onto the surface, W·m⁻²·sr⁻¹ of the path"));
    for (const PixelColumn column : {factor, light, value})
        tree_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    tree_->setUniformRowHeights(true);
    tree_->setAlternatingRowColors(true);
    tree_->header()->setStretchLastSection(false);
    tree_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    tree_->setIndentation(12);
    tree_->setMinimumSize(240, 80); // its columns scroll
    words_ = new QLabel(this);
    words_->setObjectName("pixelWords");
    words_->setWordWrap(true);
    words_->setForegroundRole(QPalette::PlaceholderText);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* head = new QHBoxLayout;
    head->addWidget(title_, 1);
    head->addWidget(copy_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 0, 0, 0);
    column->addLayout(head);
    column->addWidget(tree_, 1);
    column->addWidget(words_);
    connect(copy_, &QToolButton::clicked, this, &PixelPanel::copy);
    setMaker({});
}

void PixelPanel::setMaker(Maker maker) {
    making_.cancel();
    asking_.cancel();
    maker_ = std::move(maker);
    explainer_.reset();
    asked_.reset();
    answer_.reset();
    hasFailed_ = false;
    tree_->clear();
    copy_->setEnabled(false);
    title_->setText(tr("Pixel"));
    words_->setText(tr("Click a pixel, or go to it by the arrows and press Return, to see what it "
                       "is made of."));
}

void PixelPanel::prepare() {
    if (!maker_ || explainer_ || making_.isBusy())
        return;
    hasFailed_ = false;
    words_->setText(tr("Rendering the image again to explain it…"));
    making_.run<std::shared_ptr<PixelExplainer>>(
        maker_(),
        [this](std::shared_ptr<PixelExplainer> made) {
            explainer_ = std::move(made);
            words_->setText(tr("Click a pixel, or go to it by the arrows and press Return, to see "
                               "what it is made of."));
            explain();
        },
        [this](const std::exception_ptr& thrown) { fail(thrown); });
}

void PixelPanel::ask(const QPoint& pixel, const std::optional<double>& inImage) {
    asked_ = pixel;
    inImage_ = inImage;
    title_->setText(tr("Pixel %1, %2").arg(pixel.x()).arg(pixel.y()));
    if (explainer_)
        explain();
    else
        prepare();
}

void PixelPanel::explain() {
    if (!asked_)
        return;
    asking_.run<ExplainedPixel>(
        [explainer = explainer_, pixel = *asked_, inImage = inImage_] {
            ExplainedPixel explained = explainer->explain(pixel.x(), pixel.y());
            explained.inImage_W_m2_sr = inImage;
            return explained;
        },
        [this](const ExplainedPixel& pixel) { show(pixel); },
        [this](const std::exception_ptr& thrown) { fail(thrown); });
}

void PixelPanel::show(const ExplainedPixel& pixel) {
    answer_ = pixel;
    tree_->setUpdatesEnabled(false);
    tree_->header()->setSectionResizeMode(QHeaderView::Fixed); // columns are measured once
    tree_->clear();
    tree_->addTopLevelItems(pixelHeads(tree_->font(), pixel));
    tree_->expandAll();
    tree_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    tree_->setUpdatesEnabled(true);
    copy_->setEnabled(true);
    QStringList remarks;
    if (!pixel.computed.isInterior && pixel.computed.samples > 0)
        remarks << tr("Where edges cross the pixel, a ray and the rendered sample may be on "
                      "different sides of an edge.");
    for (const std::string& remark : pixel.computed.remarks)
        remarks << QString::fromStdString(remark);
    words_->setText(remarks.join('\n'));
    emit answered();
}

void PixelPanel::fail(const std::exception_ptr& thrown) {
    answer_.reset();
    hasFailed_ = true;
    tree_->clear();
    copy_->setEnabled(false);
    words_->setText(tr("The pixels of this image cannot be explained.") + "\n" +
                    sentencesOf(thrown).join('\n'));
    emit answered();
}

QString PixelPanel::text() const {
    return answer_
               ? QString::fromStdString(explanationText({*answer_}, explainer_->drawn().renderer))
               : QString();
}

QString PixelPanel::problem() const {
    return hasFailed_ ? words_->text() : QString();
}

void PixelPanel::copy() const {
    QGuiApplication::clipboard()->setText(text());
}

} // namespace smat::gui

#include "moc_PixelPanel.cpp"
