#include "irsg/render/sampling/Partition.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>

namespace irsg {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double areaOf(const ImageRectangle& r) {
    return r.empty() ? 0.0 : r.width() * r.height();
}

/// What a side of a line holds of a thing.
struct Piece {
    ImageRectangle rectangle;
    std::size_t thing;
};

ImageRectangle around(const std::vector<Piece>& pieces) {
    ImageRectangle all;
    for (const Piece& piece : pieces)
        all = all.unitedWith(piece.rectangle);
    return all;
}

struct Line {
    bool isUpright = true;
    double place = 0.0, area = infinity; ///< left on both sides of it
};

double low(const Piece& piece, bool isUpright) {
    return isUpright ? piece.rectangle.left : piece.rectangle.top;
}
double high(const Piece& piece, bool isUpright) {
    return isUpright ? piece.rectangle.right : piece.rectangle.bottom;
}

std::vector<Piece> sideOf(const std::vector<Piece>& pieces, const Line& line, bool isBefore) {
    std::vector<Piece> side;
    for (Piece piece : pieces) {
        ImageRectangle& r = piece.rectangle;
        double& edge =
            line.isUpright ? (isBefore ? r.right : r.left) : (isBefore ? r.bottom : r.top);
        edge = isBefore ? std::min(edge, line.place) : std::max(edge, line.place);
        if (!r.empty())
            side.push_back(piece);
    }
    return side;
}

/// Of the lines between pieces the one that leaves the least area; where all lines meet some, of
/// those in the middle along either axis.
Line bestLine(const std::vector<Piece>& pieces) {
    Line best;
    for (const bool isUpright : {true, false}) {
        std::vector<Piece> sorted = pieces;
        std::ranges::stable_sort(sorted, {},
                                 [&](const Piece& piece) { return low(piece, isUpright); });
        std::vector<double> areaAfter(sorted.size() + 1);
        ImageRectangle after;
        for (std::size_t i = sorted.size(); i-- > 0;) {
            after = after.unitedWith(sorted[i].rectangle);
            areaAfter[i] = areaOf(after);
        }
        ImageRectangle before = sorted.front().rectangle;
        double reach = high(sorted.front(), isUpright);
        for (std::size_t i = 1; i < sorted.size(); ++i) {
            const double area = areaOf(before) + areaAfter[i];
            if (const double place = low(sorted[i], isUpright); place >= reach && area < best.area)
                best = {isUpright, place, area};
            before = before.unitedWith(sorted[i].rectangle);
            reach = std::max(reach, high(sorted[i], isUpright));
        }
    }
    if (best.area < infinity)
        return best;
    for (const bool isUpright : {true, false}) {
        std::vector<double> places;
        for (const Piece& piece : pieces)
            places.push_back(low(piece, isUpright)), places.push_back(high(piece, isUpright));
        std::ranges::sort(places);
        constexpr std::size_t tried = 8;
        for (std::size_t i = 1; i < tried; ++i) {
            const Line line{isUpright, places[i * places.size() / tried], 0.0};
            const double area = areaOf(around(sideOf(pieces, line, true))) +
                                areaOf(around(sideOf(pieces, line, false)));
            if (area < best.area)
                best = {isUpright, line.place, area};
        }
    }
    return best;
}

struct Node {
    std::vector<Piece> pieces;
    ImageRectangle rectangle;
    std::unique_ptr<Node> before, after;

    bool isLeaf() const { return !before; }
    void makeLeaf() { before.reset(), after.reset(); }
    double area() const { return isLeaf() ? areaOf(rectangle) : before->area() + after->area(); }
    std::size_t leaves() const { return isLeaf() ? 1 : before->leaves() + after->leaves(); }
};

std::unique_ptr<Node> divide(std::vector<Piece> pieces, double waste) {
    auto node = std::make_unique<Node>();
    node->rectangle = around(pieces);
    node->pieces = std::move(pieces);
    if (node->pieces.size() < 2)
        return node;
    // A line through things is worth it only where it leaves much out.
    constexpr double least = 0.95;
    const Line line = bestLine(node->pieces);
    std::vector<Piece> before = sideOf(node->pieces, line, true);
    std::vector<Piece> after = sideOf(node->pieces, line, false);
    const bool isClean = before.size() + after.size() == node->pieces.size();
    if (before.empty() || after.empty() ||
        (!isClean && line.area > least * areaOf(node->rectangle)))
        return node;
    node->before = divide(std::move(before), waste);
    node->after = divide(std::move(after), waste);
    if (areaOf(node->rectangle) <= waste * node->area())
        node->makeLeaf();
    return node;
}

/// The node above two leaves that grows least as one.
Node* cheapest(Node& node, double& least) {
    if (node.isLeaf())
        return nullptr;
    if (node.before->isLeaf() && node.after->isLeaf()) {
        const double grown = areaOf(node.rectangle) - node.area();
        return grown < least ? (least = grown, &node) : nullptr;
    }
    Node* first = cheapest(*node.before, least);
    Node* second = cheapest(*node.after, least);
    return second ? second : first;
}

void collect(const Node& node, std::vector<Enclosure>& into) {
    if (!node.isLeaf()) {
        collect(*node.before, into);
        collect(*node.after, into);
        return;
    }
    Enclosure& enclosure = into.emplace_back(Enclosure{node.rectangle, {}});
    for (const Piece& piece : node.pieces)
        enclosure.things.push_back(piece.thing);
}

} // namespace

std::vector<Enclosure> partition(const std::vector<ImageRectangle>& things, double waste,
                                 std::size_t most) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < things.size(); ++i)
        if (!things[i].empty())
            pieces.push_back({things[i], i});
    std::vector<Enclosure> result;
    if (pieces.empty())
        return result;
    std::ranges::stable_sort(pieces, {}, [](const Piece& piece) {
        const ImageRectangle& r = piece.rectangle;
        return std::tuple(r.left, r.top, r.right, r.bottom);
    });
    const std::unique_ptr<Node> all = divide(std::move(pieces), waste);
    for (std::size_t leaves = all->leaves(); leaves > most; --leaves) {
        double least = infinity;
        Node* node = cheapest(*all, least);
        node->makeLeaf();
    }
    collect(*all, result);
    return result;
}

} // namespace irsg
