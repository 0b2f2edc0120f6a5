#pragma once

#include <vector>

#include <QHBoxLayout>
#include <QLabel>
#include <QWidget>

#include "gui/widgets/NumberField.h"
#include "irsg/signature/EntryFields.h"

namespace smat::gui {

/// A field for a number of an entry, with its range, step, unit and help.
NumberField* makeNumberField(const char* key, const char* unit, const char* help,
                             const irsg::NumberRules& rules, QWidget* parent);

/// The label of a field in a form: a digit behind a letter goes below.
QLabel* makeFieldLabel(const char* label, QWidget* parent);

/// The numbers of an entry, or of a part of one, as its table of fields has them: a form that needs
/// no change when a number is added.
template <typename Entry>
class EntryNumbers {
  public:
    using Row = irsg::EntryField<Entry>;

    /// Makes the fields, children of `parent`. `edited(row, value)` is called for what a person
    /// types, `finished()` when the typing is over. Of all rows those that `belongs` says.
    template <typename Edited, typename Finished, typename Belongs>
    EntryNumbers(std::span<const Row> rows, QWidget* parent, Edited edited, Finished finished,
                 Belongs belongs) {
        irsg::forEachField<double>(rows, [&](const Row& row, auto member) {
            if (!belongs(row))
                return;
            auto* field = makeNumberField(row.key, row.unit, row.help, row.number, parent);
            QObject::connect(field, &NumberField::edited, parent,
                             [&row, edited](double value) { edited(row, value); });
            QObject::connect(field, &NumberField::finished, parent, finished);
            shown_.push_back({&row, member, makeFieldLabel(row.label, parent), field});
        });
    }

    template <typename Edited, typename Finished>
    EntryNumbers(std::span<const Row> rows, QWidget* parent, Edited edited, Finished finished)
        : EntryNumbers(rows, parent, edited, finished, [](const Row&) { return true; }) {}

    void show(const Entry& entry) {
        for (const Shown& each : shown_)
            each.field->setValue(entry.*each.member);
    }
    /// Shows the fields of some rows alone.
    template <typename Belongs>
    void showOnly(Belongs belongs) {
        for (const Shown& each : shown_) {
            each.label->setVisible(belongs(*each.row));
            each.field->setVisible(belongs(*each.row));
        }
    }
    /// In pairs, each a label and its field, `perLine` of them a line.
    template <typename Grid>
    void addTo(Grid& grid, int perLine) const {
        for (std::size_t i = 0; i < shown_.size(); ++i) {
            const int line = static_cast<int>(i) / perLine;
            const int column = 2 * (static_cast<int>(i) % perLine);
            grid.addWidget(shown_[i].label, line, column);
            grid.addWidget(shown_[i].field, line, column + 1);
            grid.setColumnStretch(column + 1, 1);
        }
    }

  private:
    struct Shown {
        const Row* row;
        double Entry::*member;
        QLabel* label;
        NumberField* field;
    };
    std::vector<Shown> shown_;
};

} // namespace smat::gui
