// SPDX-License-Identifier: Apache-2.0
// Compares the places of keys; see key_places.h.
#include "tests/looks/checks/key_places.h"

#include <QColor>
#include <QQuickItem>
#include <QRegion>

#include <algorithm>
#include <array>
#include <cmath>

namespace campanel::looks {
namespace {

constexpr double movePx = 1.0;

// The screens that are states of one page, between which nobody but the machine or an edit leads.
const QMap<QString, QStringList>& states()
{
    static const QMap<QString, QStringList> all{
        {QStringLiteral("Run, packing"),
         {QStringLiteral("run-empty"), QStringLiteral("run-stopped"), QStringLiteral("run"),
          QStringLiteral("run-fault"), QStringLiteral("run-fresh"), QStringLiteral("run-many-alarms"),
          QStringLiteral("run-product-across"), QStringLiteral("run-marks-lost"), QStringLiteral("run-lost"),
          QStringLiteral("run-stop-waits")}},
        {QStringLiteral("Run, cam"),
         {QStringLiteral("run-cam"), QStringLiteral("run-cam-stopped"), QStringLiteral("run-cam-lost")}},
        {QStringLiteral("Run, press"),
         {QStringLiteral("run-press"), QStringLiteral("run-press-stopped"), QStringLiteral("run-press-fresh"),
          QStringLiteral("run-press-fault"), QStringLiteral("run-press-lost")}},
        {QStringLiteral("Motion"),
         {QStringLiteral("motion"), QStringLiteral("motion-edited"), QStringLiteral("motion-refused"),
          QStringLiteral("motion-limits"), QStringLiteral("motion-ramps"), QStringLiteral("motion-fault"),
          QStringLiteral("motion-many-alarms"), QStringLiteral("motion-lost")}},
        {QStringLiteral("Motion, operator"),
         {QStringLiteral("motion-operator"), QStringLiteral("motion-operator-refused"),
          QStringLiteral("motion-operator-stroke")}},
    };
    return all;
}

// A pair of keys, or a key alone, that may take another place; the reason stands beside it.
struct Exception {
    const char* key;
    const char* other; // the same key: it moves
    const char* reason;
};

constexpr std::array exceptions{
    Exception{"openMotion", "bannerWay", "a program comes by a download, not between two taps"},
    Exception{"faultCard", "downloadAgain",
              "a fault and a lost program do not follow one another within two taps"},
    Exception{"speedKey", "middleKey",
              "a tap on Reset or Reference run does nothing, a hold on Speed neither"},
};

bool isExcepted(const QString& key, const QString& other)
{
    const auto is = [](const char* name, const QString& text) { return text == QLatin1String(name); };
    return std::ranges::any_of(exceptions, [&](const Exception& each) {
        return (is(each.key, key) && is(each.other, other)) || (is(each.key, other) && is(each.other, key));
    });
}

bool isKey(const QQuickItem& item)
{
    return item.inherits("QQuickAbstractButton");
}

QString keyName(const QQuickItem& item)
{
    return item.objectName().isEmpty() ? item.property("text").toString() : item.objectName();
}

QRectF placeOf(const QQuickItem& item)
{
    return item.mapRectToScene(item.boundingRect());
}

// Returns whether nobody sees through the item: a card, a key's background, the dark veil below a sheet.
bool covers(const QQuickItem& item)
{
    constexpr int minAlpha = 100; // of 255
    return item.inherits("QQuickRectangle") && item.property("color").value<QColor>().alpha() > minAlpha;
}

bool isWithin(const QQuickItem& ancestor, const QQuickItem* item)
{
    while (item && item != &ancestor)
        item = item->parentItem();
    return item != nullptr;
}

// One thing on the screen, in the order of painting.
struct Painted {
    const QQuickItem* item;
    QRectF place;    // what is left of it within the clips around it
    bool isScrolled; // a list or flickable cuts it
};

void collect(const QQuickItem& item, const QRectF& clip, bool isScrolled, QList<Painted>& found)
{
    if (!item.isVisible() || item.opacity() <= 0)
        return;
    const QRectF place = placeOf(item);
    if (isKey(item) || covers(item))
        found.append({&item, place.intersected(clip), isScrolled && !clip.contains(place)});
    const bool scrolls = item.inherits("QQuickFlickable");
    const QRectF inner = item.clip() || scrolls ? clip.intersected(place) : clip;
    QList<QQuickItem*> children = item.childItems();
    std::ranges::stable_sort(children, {}, [](const QQuickItem* child) { return child->z(); });
    for (const QQuickItem* child : children)
        collect(*child, inner, isScrolled || scrolls, found);
}

QList<Painted> painted(QQuickItem& root)
{
    QList<Painted> found;
    collect(root, placeOf(root), false, found);
    return found;
}

// Returns what can be seen of a key.
QRegion sightOf(const QList<Painted>& all, qsizetype index)
{
    const Painted& key = all[index];
    QRegion sight(key.place.toAlignedRect());
    for (auto above = all.begin() + index + 1; above != all.end(); ++above) {
        if (!isWithin(*key.item, above->item))
            sight -= above->place.toRect();
    }
    return sight;
}

// Returns whether the key's center and four places near its corners can be seen.
bool isWhole(const QList<Painted>& all, qsizetype index)
{
    const QRect key = placeOf(*all[index].item).toRect();
    const int x = key.width() / 8;
    const int y = key.height() / 8;
    const QRect inner = key.adjusted(x, y, -x, -y);
    const QRegion sight = sightOf(all, index);
    const std::array probes{inner.center(), inner.topLeft(), inner.topRight(), inner.bottomLeft(),
                            inner.bottomRight()};
    return std::ranges::all_of(probes, [&](const QPoint& probe) { return sight.contains(probe); });
}

// Returns whether a person goes on with this key: it must not be covered at all.
bool isNextStep(const QQuickItem& item)
{
    static const QStringList names{
        QStringLiteral("undo"),         QStringLiteral("redo"),      QStringLiteral("nextStep"),
        QStringLiteral("startKey"),     QStringLiteral("middleKey"), QStringLiteral("stopKey"),
        QStringLiteral("bannerButton"), QStringLiteral("bannerWay"), QStringLiteral("sheetClose")};
    const QQuickItem* parent = item.parentItem();
    return names.contains(item.objectName()) || item.inherits("KeypadKey") ||
           (parent && (parent->objectName() == QLatin1String("sheetFooter") ||
                       parent->objectName() == QLatin1String("sheetHeader")));
}

} // namespace

QStringList checkCovered(QQuickItem& root)
{
    QStringList faults;
    const QList<Painted> all = painted(root);
    for (qsizetype i = 0; i < all.size(); ++i) {
        const QQuickItem& item = *all[i].item;
        if (!isKey(item) || !isNextStep(item) || !item.isEnabled() || all[i].isScrolled || isWhole(all, i))
            continue;
        const QSize left = sightOf(all, i).boundingRect().size();
        if (left.width() > movePx && left.height() > movePx)
            faults += QStringLiteral("%1 is covered in part, %2 x %3 px are left")
                          .arg(keyName(item))
                          .arg(left.width())
                          .arg(left.height());
    }
    return faults;
}

void KeyPlaces::add(const QString& screen, QQuickItem& root)
{
    for (auto page = states().cbegin(); page != states().cend(); ++page) {
        if (!page->contains(screen))
            continue;
        State state{screen, {}};
        const QList<Painted> all = painted(root);
        for (qsizetype i = 0; i < all.size(); ++i) {
            if (isKey(*all[i].item) && !all[i].isScrolled && isWhole(all, i))
                state.keys.insert(keyName(*all[i].item), all[i].place);
        }
        m_pages[page.key()] += state;
    }
}

QStringList KeyPlaces::faults() const
{
    QStringList faults;
    const auto moves = [](const QRectF& a, const QRectF& b) {
        return std::abs(a.left() - b.left()) > movePx || std::abs(a.top() - b.top()) > movePx ||
               std::abs(a.right() - b.right()) > movePx || std::abs(a.bottom() - b.bottom()) > movePx;
    };
    const auto say = [&faults](const QString& fault) {
        if (!faults.contains(fault))
            faults += fault;
    };
    for (auto page = m_pages.cbegin(); page != m_pages.cend(); ++page) {
        for (const State& one : *page) {
            for (const State& two : *page) {
                for (auto key = one.keys.cbegin(); key != one.keys.cend(); ++key) {
                    if (two.keys.contains(key.key()) && moves(key.value(), two.keys[key.key()]) &&
                        !isExcepted(key.key(), key.key()))
                        say(QStringLiteral("%1: %2 moves").arg(page.key(), key.key()));
                    for (auto other = two.keys.cbegin(); other != two.keys.cend(); ++other) {
                        const bool isNew = other.key() != key.key() && !one.keys.contains(other.key());
                        if (isNew && key.value().intersects(other.value()) &&
                            !isExcepted(key.key(), other.key()))
                            say(QStringLiteral("%1: %2 of %3 takes the place of %4 of %5")
                                    .arg(page.key(), other.key(), two.screen, key.key(), one.screen));
                    }
                }
            }
        }
    }
    return faults;
}

} // namespace campanel::looks
