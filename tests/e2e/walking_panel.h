// SPDX-License-Identifier: Apache-2.0
// A panel with campanel-controller at the other end of the line, operated by the names that a screen reader
// says, as a person operates it. Counts the touches and measures the time of a walk.
#pragma once

#include "panel_window.h"
#include "tests/support/controller_process.h"

#include <QAccessible>
#include <QElapsedTimer>

#include <cstdio>
#include <functional>

namespace campanel::test {

class WalkingPanel {
public:
    explicit WalkingPanel(PanelWindow::Library library)
        : m_window(m_controller.port(), QStringLiteral("en"), library)
    {
    }

    [[nodiscard]] PanelWindow& window() { return m_window; }
    [[nodiscard]] ControllerProcess& process() { return m_controller; }
    [[nodiscard]] panel::Controller& controller() { return m_window.controller(); }
    [[nodiscard]] panel::Editor& editor() { return m_window.editor(); }

    // Each of them waits until a finger reaches what it names, and counts one touch.
    void tap(const QString& name)
    {
        if (QQuickItem* item = reached(name))
            m_window.touchDriver().tap(*item);
    }
    void hold(const QString& name)
    {
        QQuickItem* item = reached(name);
        if (!item)
            return;
        m_window.touchDriver().touch(*item);
        QTest::qWait(holdMs);
        m_window.touchDriver().lift();
        m_window.touchDriver().settle();
    }
    // Drags what has that object name by so many px.
    void drag(const char* objectName, const QPointF& by)
    {
        ++m_touches;
        looks::TouchDriver& driver = m_window.touchDriver();
        driver.touch(QLatin1String(objectName));
        if (const QQuickItem* item = driver.find(QLatin1String(objectName)))
            driver.slide(item->mapToScene(item->boundingRect().center()) + by);
        driver.lift();
        driver.settle();
    }
    // One touch for each key of a keypad or keyboard.
    void keys(const QString& keys)
    {
        for (const QChar key : keys)
            tap(QString(key));
    }
    // No touch: the machine or the panel works. What did not come is a complaint and ends the walk.
    void waitFor(const char* what, const std::function<bool()>& isTrue)
    {
        if (!m_missing.isEmpty())
            return;
        const bool came = QTest::qWaitFor(
            [&] {
                m_window.touchDriver().settle();
                return isTrue();
            },
            timeoutMs);
        if (!came)
            m_missing +=
                QStringLiteral("%1 did not come; on the screen:\n%2").arg(QLatin1String(what), texts());
    }
    void waitForText(const char* text)
    {
        waitFor(text, [&] { return texts().contains(QString::fromUtf8(text)); });
    }

    // Starts to count and to measure.
    void begin()
    {
        m_touches = 0;
        m_passed.start();
    }
    [[nodiscard]] int touches() const { return m_touches; }
    [[nodiscard]] double seconds() const { return static_cast<double>(m_passed.elapsed()) / msPerSecond; }
    [[nodiscard]] QStringList complaints() const { return m_window.complaints() + m_missing; }

private:
    // Every text on the screen; a number and its unit do not break there.
    [[nodiscard]] QString texts()
    {
        return m_window.texts().replace(QChar::Nbsp, u' ').remove(QChar(0x2060));
    }
    static constexpr int timeoutMs = 30'000;
    static constexpr int holdMs = 600;
    static constexpr double msPerSecond = 1000;

    QQuickItem* reached(const QString& name)
    {
        ++m_touches;
        QQuickItem* item = nullptr;
        const auto isReached = [&] {
            m_window.touchDriver().settle();
            item = m_window.touchDriver().findNamed(name);
            return item != nullptr;
        };
        // One that is missing ends the walk: the others would only wait.
        if (m_missing.isEmpty() && !QTest::qWaitFor(isReached, timeoutMs))
            m_missing += QStringLiteral("\"%1\" cannot be touched; a finger reaches: %2")
                             .arg(name, names(m_window.touchDriver().root()).join(u", "));
        return item;
    }
    QStringList names(QQuickItem& below)
    {
        const QAccessibleInterface* interface =
            below.isVisible() ? QAccessible::queryAccessibleInterface(&below) : nullptr;
        const QString name = interface ? interface->text(QAccessible::Name) : QString();
        QStringList found;
        if (!name.isEmpty() && m_window.touchDriver().findNamed(name) == &below)
            found += name;
        for (QQuickItem* child : below.childItems())
            found += names(*child);
        return found;
    }

    ControllerProcess m_controller{{QStringLiteral("--control")}};
    PanelWindow m_window;
    QStringList m_missing;
    QElapsedTimer m_passed;
    int m_touches = 0;
};

struct Walk {
    const char* number; // a letter for a part of a walk
    const char* name;
    int maxTouches;
    PanelWindow::Library library;
    void (*prepare)(WalkingPanel&); // not counted
    void (*walk)(WalkingPanel&);
};

inline void waitForController(WalkingPanel& panel)
{
    panel.waitFor("a controller",
                  [&] { return panel.controller().state() == panel::Controller::State::Idle; });
    panel.waitFor("the recipes", [&] { return panel.window().panel().recipes().ready(); });
}

// Brings the machine to its run from the Run page.
inline void run(WalkingPanel& panel)
{
    waitForController(panel);
    panel.tap("Motion");
    panel.tap("Download");
    panel.tap("Download");
    panel.waitFor("a program", [&] { return panel.controller().canStart(); });
    panel.hold("Start");
    panel.tap("Run");
    panel.waitFor("a run", [&] { return panel.controller().state() == panel::Controller::State::Running; });
}

// Does a walk and prints it as a row of docs/figures.md. No more touches than its maximum are accepted.
inline void doWalk(const Walk& row)
{
    WalkingPanel panel(row.library);
    row.prepare(panel);
    QCOMPARE(panel.complaints().join(u'\n'), QString());
    panel.begin();
    row.walk(panel);
    const double seconds = panel.seconds();
    QCOMPARE(panel.complaints().join(u'\n'), QString());
    std::printf("| %s | %s | %d | %.1f |\n", row.number, row.name, panel.touches(), seconds);
    std::fflush(stdout);
    QVERIFY2(panel.touches() <= row.maxTouches,
             qPrintable(QStringLiteral("%1 touches").arg(QString::number(panel.touches()))));
}

} // namespace campanel::test
