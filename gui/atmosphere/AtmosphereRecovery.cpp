#include "gui/atmosphere/AtmosphereRecovery.h"

#include <utility>

#include "gui/atmosphere/AtmosphereDocument.h"
#include "gui/start/DataFolder.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "smatcore/support/TextFile.h"

namespace smat::gui {
namespace {

constexpr int delay_ms = 1500;

/// What its copies lie beside.
std::filesystem::path baseOfAtmosphere(const std::filesystem::path& file) {
    return placeForUnsaved(file, "new-air.xml");
}

} // namespace

AtmosphereRecovery::AtmosphereRecovery(AtmosphereDocument& document, QObject* parent)
    : QObject(parent), document_(document), file_(document.file()) {
    timer_.setSingleShot(true);
    timer_.setInterval(delay_ms);
    connect(&timer_, &QTimer::timeout, this, &AtmosphereRecovery::writeNow);
    connect(&document_, &AtmosphereDocument::stateChanged, this, &AtmosphereRecovery::follow);
}

void AtmosphereRecovery::follow() {
    if (!document_.isModified() || document_.file() != file_)
        forget();
    file_ = document_.file();
    if (document_.isModified() && !timer_.isActive())
        timer_.start();
}

void AtmosphereRecovery::writeNow() {
    timer_.stop();
    // What cannot be air cannot be read again; the last that could stays.
    if (!document_.isModified() || !document_.diagnostics().empty())
        return;
    try {
        const auto& copy = slot_.claim(baseOfAtmosphere(file_));
        writeTextFile(copy, document_.textIn(copy.parent_path()));
        slot_.setWritten();
    } catch (const std::exception&) {
        if (!std::exchange(isTold_, true))
            emit failed(tr("No recovery copy is kept: %1")
                            .arg(sentencesOf(std::current_exception()).join(' ')));
    }
}

void AtmosphereRecovery::forget() {
    timer_.stop();
    slot_.forget();
}

void AtmosphereRecovery::takeOver(const std::filesystem::path& copy) {
    document_.recover(copy);
    slot_.takeOver(copy);
    follow(); // a copy that holds nothing else than the file goes
}

std::vector<std::filesystem::path>
AtmosphereRecovery::leftBehind(const std::filesystem::path& file) {
    return RecoverySlot::leftBehind(baseOfAtmosphere(file));
}

} // namespace smat::gui

#include "moc_AtmosphereRecovery.cpp"
