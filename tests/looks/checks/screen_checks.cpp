// SPDX-License-Identifier: Apache-2.0
// Checks the screen contents; see screen_checks.h.
#include "tests/looks/checks/screen_checks.h"

#include <QAccessible>
#include <QFontMetricsF>
#include <QImage>
#include <QJSValue>
#include <QQuickItem>

#include <algorithm>
#include <cmath>

namespace campanel::looks {
namespace {

constexpr double tolerancePx = 1.0; // rounding of glyph metrics
constexpr double overlapPx = 2.0;   // font boxes are larger than the ink

struct PaintedText {
    QString text;
    QRectF rect; // painted area, in screen coordinates
};

bool isText(const QQuickItem& item)
{
    return item.inherits("QQuickText");
}

bool isButton(const QQuickItem& item)
{
    return item.inherits("QQuickAbstractButton");
}

bool isControl(const QQuickItem& item)
{
    return isButton(item) || item.inherits("QQuickSlider");
}

// Returns whether a finger uses the item itself; a bare flickable only scrolls, by the left button.
bool isTouched(const QQuickItem& item)
{
    const Qt::MouseButtons buttons = item.acceptedMouseButtons();
    const bool scrolls = item.inherits("QQuickFlickable") && buttons == Qt::LeftButton;
    return isControl(item) || (item.isEnabled() && !item.objectName().isEmpty() && buttons && !scrolls);
}

QString nameOf(const QQuickItem& item)
{
    const QString text = item.property("text").toString();
    return QStringLiteral("%1 \"%2\"").arg(item.objectName(), text);
}

// Returns the painted part of a text item in its own coordinates.
QRectF paintedRect(const QQuickItem& text)
{
    const double width = text.property("contentWidth").toDouble();
    const double height = text.property("contentHeight").toDouble();
    const int horizontal = text.property("effectiveHorizontalAlignment").toInt();
    const int vertical = text.property("verticalAlignment").toInt();
    const double left = text.property("leftPadding").toDouble();
    const double spareX = text.width() - left - text.property("rightPadding").toDouble() - width;
    const double spareY = text.height() - height;
    const double x = horizontal == Qt::AlignRight ? spareX : horizontal == Qt::AlignHCenter ? spareX / 2 : 0;
    const double y = vertical == Qt::AlignBottom ? spareY : vertical == Qt::AlignVCenter ? spareY / 2 : 0;
    // Digits alone are as high as their ink: of a large number a third of the font's box is empty.
    const QString digits = text.property("text").toString();
    const bool isNumber = std::ranges::any_of(digits, [](QChar each) { return each.isDigit(); });
    if (!isNumber ||
        std::ranges::any_of(digits, [](QChar each) { return each.isLetter() || each.isSpace(); }))
        return {left + x, y, width, height};
    QFont font = text.property("font").value<QFont>();
    font.setPixelSize(
        text.property("fontInfo").value<QJSValue>().property(QStringLiteral("pixelSize")).toInt());
    const QFontMetricsF metrics(font);
    return {left + x, y + metrics.ascent() - metrics.capHeight(), width, metrics.capHeight()};
}

// Returns the list or flickable that contains the item; null if it does not scroll.
const QQuickItem* scrollerOf(const QQuickItem& item)
{
    const QQuickItem* parent = item.parentItem();
    while (parent && !parent->inherits("QQuickFlickable"))
        parent = parent->parentItem();
    return parent;
}

// Returns true when the whole rectangle is visible, not clipped by any list or flickable around it.
bool isInSight(const QQuickItem& item, const QRectF& rect)
{
    for (const QQuickItem* scroller = scrollerOf(item); scroller; scroller = scrollerOf(*scroller)) {
        if (!scroller->mapRectToScene(scroller->boundingRect()).contains(rect))
            return false;
    }
    return true;
}

// Returns the button or surface below the text.
const QQuickItem* surfaceOf(const QQuickItem& text)
{
    const QQuickItem* parent = text.parentItem();
    while (parent && !isButton(*parent) && !parent->inherits("QQuickRectangle"))
        parent = parent->parentItem();
    return parent;
}

bool isLetterKey(const QQuickItem& item)
{
    const QString name = item.objectName();
    return name.startsWith(QLatin1String("key_")) || name == QLatin1String("nameBackspace") ||
           name == QLatin1String("nameAccept") ||
           (name.startsWith(QLatin1String("text")) && item.inherits("QQuickAbstractButton"));
}

class Checker {
public:
    Checker(const ScreenLimits& limits, const QImage& picture)
        : m_limits(limits)
        , m_picture(picture)
    {
    }

    void visit(QQuickItem& item)
    {
        if (!item.isVisible() || item.opacity() <= 0)
            return;
        if (isText(item))
            checkText(item);
        if (isButton(item) && item.isEnabled())
            checkTarget(item);
        if (isTouched(item))
            checkAccessible(item);
        for (QQuickItem* child : item.childItems())
            visit(*child);
    }

    QStringList finish()
    {
        for (qsizetype i = 0; i < m_texts.size(); ++i) {
            for (qsizetype j = i + 1; j < m_texts.size(); ++j) {
                const QRectF common = m_texts[i].rect.intersected(m_texts[j].rect);
                if (common.width() > overlapPx && common.height() > m_texts[i].rect.height() / 4)
                    m_faults +=
                        QStringLiteral("\"%1\" and \"%2\" overlap").arg(m_texts[i].text, m_texts[j].text);
            }
        }
        return m_faults;
    }

private:
    void checkText(const QQuickItem& item)
    {
        const QString text = item.property("text").toString();
        if (text.isEmpty())
            return;
        const double size =
            item.property("fontInfo").value<QJSValue>().property(QStringLiteral("pixelSize")).toNumber();
        if (size < m_limits.textPx)
            m_faults += QStringLiteral("%1 has %2 px, at least %3 are readable")
                            .arg(nameOf(item))
                            .arg(size)
                            .arg(m_limits.textPx);
        if (!m_limits.elides && item.property("truncated").toBool())
            m_faults += QStringLiteral("%1 is elided").arg(nameOf(item));
        const QRectF painted = paintedRect(item);
        if (painted.width() > item.width() + tolerancePx ||
            painted.height() > item.height() + 2 * tolerancePx)
            m_faults += QStringLiteral("%1 needs %2 x %3 and has %4 x %5")
                            .arg(nameOf(item))
                            .arg(painted.width())
                            .arg(painted.height())
                            .arg(item.width())
                            .arg(item.height());
        const QRectF rect = item.mapRectToScene(painted);
        if (isInSight(item, rect))
            checkContrast(item, rect);
        checkSurfaces(item, rect);
        if (!scrollerOf(item))
            m_texts.append({text, rect});
    }

    // Checks that the text stays on the key, tile and card that it belongs to; in a list, on those of its
    // row.
    void checkSurfaces(const QQuickItem& item, const QRectF& rect)
    {
        const QQuickItem* scroller = scrollerOf(item);
        for (const QQuickItem* surface = surfaceOf(item); surface && scrollerOf(*surface) == scroller;
             surface = surfaceOf(*surface)) {
            const QRectF limit = surface->mapRectToScene(surface->boundingRect())
                                     .adjusted(-tolerancePx, -tolerancePx, tolerancePx, tolerancePx);
            if (limit.contains(rect))
                continue;
            m_faults += QStringLiteral("%1 stands out of its surface").arg(nameOf(item));
            return;
        }
    }

    // Checks the contrast, except for disabled items (WCAG exempts them).
    void checkContrast(const QQuickItem& item, const QRectF& rect)
    {
        const double scale = m_picture.devicePixelRatio();
        const auto behind = colorBehind(m_picture, {rect.topLeft() * scale, rect.size() * scale});
        if (!behind || !item.isEnabled())
            return;
        const QColor ink = inkOn(item, *behind);
        const double ratio = contrastRatio(ink, *behind);
        const double needed = contrastNeeded(item, m_limits.contrast);
        if (ratio < needed)
            m_faults += QStringLiteral("%1 in %2 on %3 has a contrast of %4, it needs %5")
                            .arg(nameOf(item), ink.name(), behind->name())
                            .arg(ratio, 0, 'f', 2)
                            .arg(needed);
    }

    // A screen reader and a test by name need both.
    void checkAccessible(QQuickItem& item)
    {
        const QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(&item);
        if (!interface || interface->role() == QAccessible::NoRole)
            m_faults += QStringLiteral("%1 has no accessible role").arg(nameOf(item));
        else if (interface->text(QAccessible::Name).isEmpty())
            m_faults += QStringLiteral("%1 has no accessible name").arg(nameOf(item));
    }

    void checkTarget(const QQuickItem& item)
    {
        const bool isCommand =
            item.objectName() == QStringLiteral("startKey") || item.objectName() == QStringLiteral("stopKey");
        const double needed = isCommand           ? m_limits.commandPx
                              : isLetterKey(item) ? m_limits.letterPx
                                                  : m_limits.touchPx;
        const double limit = std::floor(needed) - tolerancePx;
        if (item.width() < limit || item.height() < limit)
            m_faults += QStringLiteral("%1 is %2 x %3, a finger needs %4")
                            .arg(nameOf(item))
                            .arg(item.width())
                            .arg(item.height())
                            .arg(limit);
    }

    ScreenLimits m_limits;
    const QImage& m_picture;
    QList<PaintedText> m_texts;
    QStringList m_faults;
};

QQuickItem* childNamed(QQuickItem& below, const QString& name)
{
    if (below.objectName() == name)
        return &below;
    for (QQuickItem* child : below.childItems()) {
        if (QQuickItem* found = childNamed(*child, name))
            return found;
    }
    return nullptr;
}

// Returns true for red and amber, in each theme.
bool isAlarmColor(const QColor& color)
{
    constexpr int amberEnd = 55; // degrees
    constexpr int redBegin = 340;
    constexpr int minSaturation = 110; // of 255
    constexpr int minValue = 90;
    const int hue = color.hsvHue();
    return color.hsvSaturation() >= minSaturation && color.value() >= minValue &&
           (hue <= amberEnd || hue >= redBegin);
}

} // namespace

QStringList checkCalm(const QImage& picture)
{
    constexpr int maxPixels = 200;
    int found = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x)
            found += isAlarmColor(picture.pixelColor(x, y)) ? 1 : 0;
    }
    return found <= maxPixels
               ? QStringList()
               : QStringList(QStringLiteral("%1 pixels are red or amber, though nothing is wrong; at "
                                            "most %2 may be")
                                 .arg(found)
                                 .arg(maxPixels));
}

QStringList checkScreen(QQuickItem& root, const ScreenLimits& limits, const QImage& picture)
{
    QQuickItem* layer = &root;
    for (const char* host : {"firstStart", "sheetHost", "keypadLoader", "loginLoader"}) {
        QQuickItem* item = childNamed(root, QString::fromLatin1(host));
        if (item && !item->childItems().isEmpty())
            layer = item;
    }
    Checker checker(limits, picture);
    checker.visit(*layer);
    return checker.finish();
}

} // namespace campanel::looks
