#pragma once

#include <map>
#include <optional>
#include <string>

#include <QStringList>

#include "irsg/signature/SignatureDatabase.h"

namespace smat::gui {

/// What differs between two signature databases, entry by entry: the content of a step that can be
/// undone. Costs the size of what differs, and is exact in both directions.
class DatabaseChange {
  public:
    DatabaseChange() = default;
    static DatabaseChange between(const irsg::SignatureDatabase& before,
                                  const irsg::SignatureDatabase& after);

    bool isEmpty() const;
    /// "title", "notes", "temperatures.4", "materials.2", "spectra.plume".
    QStringList places() const;
    void redo(irsg::SignatureDatabase& database) const;
    void undo(irsg::SignatureDatabase& database) const;
    /// Makes this change and `next`, which follows it, one.
    void append(const DatabaseChange& next);

  private:
    /// An entry on both sides; none where it is not there.
    template <typename Value>
    struct Difference {
        std::optional<Value> before, after;
    };
    template <typename Key, typename Value>
    using Differences = std::map<Key, Difference<Value>>;

    template <typename Key, typename Value>
    static Differences<Key, Value> compare(const std::map<Key, Value>& before,
                                           const std::map<Key, Value>& after);
    template <typename Key, typename Value>
    static void put(const Differences<Key, Value>& differences, bool after,
                    std::map<Key, Value>& into);
    template <typename Key, typename Value>
    static void join(Differences<Key, Value>& first, const Differences<Key, Value>& next);
    void apply(irsg::SignatureDatabase& database, bool after) const;

    Differences<std::string, std::string> texts_; ///< "title" and "notes"
    Differences<int, irsg::TemperatureEntry> temperatures_;
    Differences<int, irsg::Material> materials_;
    Differences<std::string, irsg::UserSpectrum> spectra_;
};

} // namespace smat::gui
