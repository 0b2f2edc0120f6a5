#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include <QWidget>

#include "gui/widgets/LatestTask.h"
#include "irsg/geometry/model/ModelPlacing.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace smat::gui {

class NumberField;
class PlacingPicture;

/// How the axes and the unit of a model's file become those of the program: fields, a guess that
/// says why, and a picture of what the fields make of it.
class PlacingFields : public QWidget {
    Q_OBJECT

  public:
    enum class Asks { all, axesAndUnit }; ///< the latter: not for the origin

    /// Fields are named `PREFIX.up` and so on.
    explicit PlacingFields(const QString& prefix, QWidget* parent = nullptr, Asks asks = Asks::all);

    /// Reads the file beside the window; one that cannot be read says so in place of the picture.
    void setFile(const std::filesystem::path& file);
    void setPlacing(const irsg::ModelPlacing& placing);
    irsg::ModelPlacing placing() const;
    /// What the file and its shape suggest; null until it is read.
    const irsg::PlacingGuess* guess() const { return shape_ ? &shape_->guess : nullptr; }
    /// Sets the fields to it; LogicError before the file is read.
    void takeGuess();
    /// Of the model as it is placed, in m about the file's origin; none until it is read.
    std::optional<irsg::BoundingBox> bounds() const;
    /// Whether up and nose go together.
    bool isRight() const;

  signals:
    void changed();
    void wasRead();

  private:
    void refresh();
    irsg::BoundingBox placedBox(const irsg::ModelPlacing& completed) const;
    bool isMade_ = false;
    bool asksForOrigin_;

    std::filesystem::path file_;
    std::shared_ptr<const irsg::ModelShape> shape_;
    QComboBox* up_ = nullptr;
    QComboBox* nose_ = nullptr;
    QComboBox* unit_ = nullptr;
    NumberField* otherUnit_ = nullptr;
    QComboBox* origin_ = nullptr;
    std::array<NumberField*, 3> point_{};
    QWidget* pointRow_ = nullptr;
    QLabel* said_ = nullptr;
    QPushButton* guess_ = nullptr;
    PlacingPicture* picture_ = nullptr;
    LatestTask task_;
};

} // namespace smat::gui
