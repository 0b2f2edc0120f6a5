#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"

namespace irsg {

/// What lies before a surface (its number in Fronts) and which row of SurfaceRows it is.
struct SurfaceStackId {
    int stack = 0, row = 0;
    bool operator==(const SurfaceStackId&) const = default;
};

/// Geometry once, physics many times: sums of factors, by cell (a pixel, or one for a whole view)
/// and by what was seen there. Sparse: a cell has entries for what it shows alone. Nothing in it
/// knows a wavelength; another band, temperature, time or scaling is a dot product, without
/// drawing.
template <typename Real>
class GeometryBuffer {
  public:
    /// `width`: numbers of an entry.
    GeometryBuffer(std::size_t cells, std::size_t width) : width_(width), heads_(cells, none) {}
    GeometryBuffer() = default;

    std::size_t width() const { return width_; }
    std::size_t cells() const { return heads_.size(); }
    const std::vector<SurfaceStackId>& kinds() const { return kinds_; }
    std::size_t entries() const { return entries_.size(); }

    int kindOf(const SurfaceStackId& kind) {
        const auto stack = static_cast<std::size_t>(kind.stack);
        const auto row = static_cast<std::size_t>(kind.row);
        if (stack >= numbers_.size())
            numbers_.resize(stack + 1);
        if (row >= numbers_[stack].size())
            numbers_[stack].resize(row + 1, none);
        std::int32_t& number = numbers_[stack][row];
        if (number == none) {
            number = static_cast<std::int32_t>(kinds_.size());
            kinds_.push_back(kind);
            here_.push_back(none);
        }
        return number;
    }

    /// The numbers of a kind in a cell, 0 at first. Valid until the next call.
    Real* at(std::size_t cell, int kind) {
        if (cell != cell_)
            goTo(cell);
        std::int32_t& entry = here_[static_cast<std::size_t>(kind)];
        if (entry == none)
            entry = append(cell, kind);
        return &values_[static_cast<std::size_t>(entry) * width_];
    }

    /// Calls visit(kind number, numbers) for the entries of a cell in the order of their making.
    template <typename Visit>
    void forEach(std::size_t cell, Visit visit) const {
        for (std::int32_t i = heads_[cell]; i != none;
             i = entries_[static_cast<std::size_t>(i)].next)
            visit(static_cast<std::size_t>(entries_[static_cast<std::size_t>(i)].kind),
                  std::span<const Real>(&values_[static_cast<std::size_t>(i) * width_], width_));
    }

    /// Adds a field of equal width times a scale, entry by entry in its order. `cellOf(cell)` is
    /// the cell here of one there, `stackOf(front)` likewise.
    template <typename Other, typename CellOf, typename StackOf>
    void add(const GeometryBuffer<Other>& other, CellOf cellOf, StackOf stackOf, Real scale = 1) {
        std::vector<int> kinds;
        for (const SurfaceStackId& kind : other.kinds())
            kinds.push_back(kindOf({stackOf(kind.stack), kind.row}));
        for (std::size_t cell = 0; cell < other.cells(); ++cell)
            other.forEach(cell, [&](std::size_t kind, std::span<const Other> numbers) {
                Real* sums = at(cellOf(cell), kinds[kind]);
                for (std::size_t i = 0; i < width_; ++i)
                    sums[i] += scale * static_cast<Real>(numbers[i]);
            });
    }

  private:
    static constexpr std::int32_t none = -1;
    struct Entry {
        std::int32_t kind, next;
    };

    void goTo(std::size_t cell) {
        for (const int kind : touched_)
            here_[static_cast<std::size_t>(kind)] = none;
        touched_.clear();
        cell_ = cell;
        last_ = none;
        for (std::int32_t i = heads_[cell]; i != none;
             i = entries_[static_cast<std::size_t>(i)].next) {
            const std::int32_t kind = entries_[static_cast<std::size_t>(i)].kind;
            here_[static_cast<std::size_t>(kind)] = i;
            touched_.push_back(kind);
            last_ = i;
        }
    }

    std::int32_t append(std::size_t cell, int kind) {
        if (entries_.size() >= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
            throw LogicError("more surfaces in the pixels of a view than can be counted");
        const auto entry = static_cast<std::int32_t>(entries_.size());
        entries_.push_back({kind, none});
        values_.resize(values_.size() + width_);
        (last_ == none ? heads_[cell] : entries_[static_cast<std::size_t>(last_)].next) = entry;
        last_ = entry;
        touched_.push_back(kind);
        return entry;
    }

    std::size_t width_ = 0;
    std::vector<std::int32_t> heads_; // first entry of each cell
    std::vector<Entry> entries_;
    std::vector<Real> values_;
    std::vector<SurfaceStackId> kinds_;
    std::vector<std::vector<std::int32_t>> numbers_; // [front][row]: kind
    // Of the cell that was written last: the entry of each kind, and the last of its list.
    std::size_t cell_ = std::numeric_limits<std::size_t>::max();
    std::int32_t last_ = none;
    std::vector<std::int32_t> here_;
    std::vector<int> touched_;
};

} // namespace irsg
