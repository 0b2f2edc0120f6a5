#pragma once

#include <optional>
#include <string>
#include <vector>

#include "irsg/signature/SignatureDatabase.h"

namespace smat::gui {

enum class EntryKind { material, temperature, spectrum };

/// Which entry of a database: an index of a material or temperature, or the name of a spectrum.
struct EntryKey {
    EntryKind kind = EntryKind::material;
    int index = 0;
    std::string name = {};

    auto operator<=>(const EntryKey&) const = default;
};

/// Edits of whole entries. Each leaves the database as it is and answers false where the entry it
/// is about is not there, or where the place it would go to is taken.
bool contains(const irsg::SignatureDatabase& database, const EntryKey& key);
/// "materials.3": how findings and changes name it.
std::string placeOf(const EntryKey& key);
/// The entry that a place lies in: "materials.3.emissivity at 4 um" lies in material 3.
std::optional<EntryKey> entryAt(const irsg::SignatureDatabase& database, const std::string& place);

/// The first index from `from` on without an entry.
int freeIndex(const irsg::SignatureDatabase& database, EntryKind kind, int from = 1);
/// `wanted`, or "wanted 2", "wanted 3" and so on.
std::string freeSpectrumName(const irsg::SignatureDatabase& database, const std::string& wanted);

bool removeEntry(irsg::SignatureDatabase& database, const EntryKey& key);
/// A copy of an entry under another index or name, which must be free.
bool duplicateEntry(irsg::SignatureDatabase& database, const EntryKey& from, const EntryKey& to);
/// Temperatures follow a spectrum that gets another name. Faces of the model keep their codes.
bool renumberEntry(irsg::SignatureDatabase& database, const EntryKey& from, const EntryKey& to);
/// Temperatures that use a spectrum.
std::vector<int> usersOfSpectrum(const irsg::SignatureDatabase& database, const std::string& name);

/// One entry to be taken over from another database.
struct EntryCopy {
    EntryKey from;
    EntryKey to;
    bool replace = false; ///< what stands at `to` goes; else the copy is left out
};
/// Takes entries over; temperatures follow spectra that come under another name in the same go, and
/// bring the spectrum that they use where the database has none of that name. Answers how many
/// came.
int copyEntries(const irsg::SignatureDatabase& source, const std::vector<EntryCopy>& copies,
                irsg::SignatureDatabase& into);

} // namespace smat::gui
