#pragma once

#include <filesystem>

#include <QStringList>

#include "gui/widgets/LatestTask.h"
#include "gui/workbench/ModelStore.h"
#include "gui/workbench/ModelWait.h"

namespace smat::gui {

/// Reads a model that is to be opened while what is open stays: it may be damaged, and takes its
/// time. What was read serves the view afterwards. The last one asked for counts.
class ModelOpening : public ModelWait {
    Q_OBJECT

  public:
    explicit ModelOpening(std::shared_ptr<ModelStore> models, QObject* parent = nullptr);

    /// Returns at once; one of wasRead and failed follows.
    void read(const std::filesystem::path& file);
    bool isBusy() const override { return task_.isBusy(); }

  signals:
    void wasRead(const std::filesystem::path& file);
    void failed(const QStringList& sentences);

  private:
    void letGo() override { task_.cancel(); }

    std::shared_ptr<ModelStore> models_;
    LatestTask task_;
};

} // namespace smat::gui
