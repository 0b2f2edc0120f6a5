#include "gui/atmosphere/AtmosphereDocument.h"

#include "gui/start/DataFolder.h"
#include "gui/widgets/NumberFormat.h"
#include "irsg/core/FileReading.h"

namespace smat::gui {
namespace {

namespace fs = std::filesystem;

/// The same ascent told from another folder; one that is told from anywhere stays.
EditedAtmosphere movedTo(EditedAtmosphere state, const fs::path& folder) {
    std::string& ascent = state.parameters.radiosonde;
    const bool isRelative =
        fs::path(ascent).is_relative() && ascent.find("KARMA_ROOT") == std::string::npos;
    if (!ascent.empty() && isRelative && !state.folder.empty() && state.folder != folder)
        ascent = (state.folder / ascent).lexically_normal().lexically_relative(folder).string();
    state.folder = folder;
    return state;
}

} // namespace

AtmosphereDocument::AtmosphereDocument(QUndoStack& undoStack, QObject* parent)
    : QObject(parent),
      undoStack_(undoStack),
      now_(std::make_shared<const EditedAtmosphere>()),
      apply_(std::make_shared<DocumentStep<EditedAtmosphere>::Apply>(
          [this](const EditedAtmosphere& state) { take(movedTo(state, file_.parent_path())); })) {}

AtmosphereDocument::AtmosphereDocument(const fs::path& file, QUndoStack& undoStack, QObject* parent)
    : AtmosphereDocument(undoStack, parent) {
    file_ = fs::absolute(file).lexically_normal();
    document_ = irsg::KarmaXml::read(file_);
    irsg::SmartReading read = irsg::fromKarma(*document_);
    // Those of the parameters change with them.
    const std::size_t ofParameters = irsg::remarksOn(read.parameters).size();
    read.remarks.resize(read.remarks.size() - ofParameters);
    unknown_ = std::move(read.remarks);
    saved_ = {std::move(read.parameters), file_.parent_path()};
    now_ = std::make_shared<const EditedAtmosphere>(saved_);
    stamp_ = irsg::stampOf(file_);
}

AtmosphereDocument::~AtmosphereDocument() {
    *apply_ = nullptr;
}

QString AtmosphereDocument::displayName() const {
    return file_.empty() ? tr("New atmosphere") : textOf(file_.filename());
}

void AtmosphereDocument::set(const irsg::AtmosphereSmartParameters& after, const QString& step,
                             int gesture) {
    if (after == now_->parameters)
        return;
    auto* command = new DocumentStep<EditedAtmosphere>(
        apply_, undoStack_, now_,
        std::make_shared<const EditedAtmosphere>(EditedAtmosphere{after, now_->folder}), gesture);
    command->setText(step);
    undoStack_.push(command);
}

void AtmosphereDocument::take(EditedAtmosphere state) {
    now_ = std::make_shared<const EditedAtmosphere>(std::move(state));
    emit changed();
    emit stateChanged();
}

std::vector<irsg::Diagnostic> AtmosphereDocument::diagnostics() const {
    return irsg::diagnosticsOf(now_->parameters);
}

QStringList AtmosphereDocument::remarks() const {
    QStringList words;
    for (const auto& some : {irsg::remarksOn(now_->parameters), unknown_})
        for (const std::string& remark : some)
            words << textOf(remark);
    return words;
}

bool AtmosphereDocument::isChangedOnDisk() const {
    const auto now = file_.empty() ? std::nullopt : irsg::stampOf(file_);
    return now && now != stamp_;
}

void AtmosphereDocument::saveAs(const fs::path& file) {
    const fs::path place = fs::absolute(file).lexically_normal();
    requireOwnPlace(place);
    std::vector<irsg::Diagnostic> wrong = diagnostics();
    for (irsg::Diagnostic& diagnostic : wrong)
        diagnostic.file = place.string();
    if (!wrong.empty())
        throw irsg::InputError(std::move(wrong));
    EditedAtmosphere state = movedTo(*now_, place.parent_path());
    irsg::KarmaXml document = xmlOf(state);
    irsg::allowChange(place);
    document.write(place);
    file_ = place;
    document_ = std::move(document);
    stamp_ = irsg::stampOf(place);
    saved_ = state;
    take(std::move(state));
}

irsg::KarmaXml AtmosphereDocument::xmlOf(const EditedAtmosphere& state) const {
    irsg::KarmaXml document = document_ ? *document_ : irsg::toKarma(state.parameters);
    irsg::toKarma(state.parameters, document);
    return document;
}

std::string AtmosphereDocument::textIn(const fs::path& folder) const {
    return xmlOf(movedTo(*now_, folder)).text();
}

void AtmosphereDocument::recover(const fs::path& copy) {
    EditedAtmosphere state{irsg::fromKarma(irsg::KarmaXml::read(copy)).parameters, {}};
    if (!file_.empty()) {
        state.folder = copy.parent_path();
        state = movedTo(std::move(state), file_.parent_path());
    }
    set(state.parameters, tr("Recover unsaved edits"));
}

bool AtmosphereDocument::isAtmosphere(const fs::path& file) {
    try {
        if (!irsg::isXml(file))
            return false;
        return irsg::readFileBeginning(file, 1 << 16).find("AtmosphereSmart") != std::string::npos;
    } catch (const irsg::InputError&) {
        return false;
    }
}

} // namespace smat::gui

#include "moc_AtmosphereDocument.cpp"
