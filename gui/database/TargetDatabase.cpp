#include "gui/database/TargetDatabase.h"

#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/SignatureFile.h"

namespace smat::gui {
namespace {

std::filesystem::path absoluteOf(const std::filesystem::path& file) {
    return file.empty() ? file : std::filesystem::absolute(file).lexically_normal();
}

} // namespace

TargetDatabase::TargetDatabase(QUndoStack& undoStack,
                               std::function<void(const std::filesystem::path&)> name)
    : session_(undoStack), name_(std::move(name)) {}

void TargetDatabase::follow(const std::filesystem::path& named,
                            const std::vector<std::filesystem::path>& ofAll, bool anew) {
    named_ = named;
    ofAll_ = ofAll;
    const auto file = absoluteOf(named);
    // Those of models that were taken out stay, too: they may come back. Of one model alone there
    // is one at a time.
    if (anew || (ofAll.size() < 2 && kept_.size() < 2))
        kept_.clear();
    if (!anew)
        for (const auto& one : ofAll)
            kept_.insert(absoluteOf(one));
    session_.keepOpen(kept_);
    if (!anew && file == session_.file() && session_.isOpen())
        return;
    problem_.clear();
    changedOutside_ = false;
    if (file.empty()) {
        session_.close();
        return;
    }
    try {
        session_.open(file);
    } catch (const irsg::InputError& error) {
        problem_ << sentencesOf(error);
        try {
            changedOutside_ = !irsg::loadSignatureFile(file, irsg::OutsideChanges::accept,
                                                       irsg::LintErrors::accept)
                                   .changedOutside.empty();
        } catch (const irsg::InputError&) {
            changedOutside_ = false;
        }
        session_.close();
    }
}

void TargetDatabase::acceptChanges() {
    session_.open(named_, irsg::OutsideChanges::accept);
    problem_.clear();
    changedOutside_ = false;
}

void TargetDatabase::use(const std::filesystem::path& file) {
    // Changes of another program are asked about and what is physically wrong is shown, once it is
    // that of the target; what cannot be read is refused before anything changes.
    irsg::loadSignatureFile(file, irsg::OutsideChanges::accept, irsg::LintErrors::accept);
    name_(absoluteOf(file));
}

void TargetDatabase::useNew(const std::filesystem::path& file, irsg::SignatureDatabase value) {
    const auto absolute = absoluteOf(file);
    session_.create(absolute, std::move(value));
    problem_.clear();
    changedOutside_ = false;
    if (named_ != absolute)
        name_(absolute);
}

void TargetDatabase::saveAs(const std::filesystem::path& file) {
    session_.saveAs(file);
    if (absoluteOf(named_) != session_.file())
        name_(session_.file());
}

SceneBuilder::DatabaseOverrides TargetDatabase::edited() const {
    SceneBuilder::DatabaseOverrides all;
    const auto others = session_.unsavedOthers();
    for (const auto& named : ofAll_)
        if (const auto found = others.find(absoluteOf(named)); found != others.end())
            all[named] = found->second;
    if (session_.isOpen() && session_.isDirty()) {
        all[named_] = session_.snapshot();
        for (const auto& named : ofAll_)
            if (absoluteOf(named) == session_.file())
                all[named] = session_.snapshot();
    }
    return all;
}

} // namespace smat::gui
