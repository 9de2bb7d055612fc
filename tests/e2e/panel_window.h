// SPDX-License-Identifier: Apache-2.0
// The complete panel on the real link, in a window operated by a TouchDriver; it records every status from
// the line.
#pragma once

#include "app/link/threaded_link.h"
#include "tests/looks/touch_driver.h"
#include "tests/support/places.h"
#include "tests/support/stored_recipe.h"

#include <QTemporaryDir>
#include <QTest>

#include <vector>

namespace campanel::test {

class PanelWindow {
public:
    enum class Library { OneRecipe, Empty }; // of a panel in use, and of a new one

    // Loads the window and connects; without a port to a simulated machine of its own. Without a folder, that
    // of an earlier panel, it has a new one: all machine data comes from the line.
    explicit PanelWindow(const QString& port, const QString& language = QStringLiteral("en"),
                         Library library = Library::OneRecipe, const QString& folder = {})
        : m_path(folder.isEmpty() ? m_folder.path() : folder)
        , m_panel(m_link, {m_path + QStringLiteral("/settings.ini"),
                           library == Library::OneRecipe ? withStoredRecipe(m_path) : m_path})
    {
        m_panel.settings().overrideValue("display.language", language);
        panel::ConnectionChoice choice;
        choice.simulated = port.isEmpty();
        choice.portName = port;
        m_panel.settings().overrideSimulator(programPath("campanel-controller"),
                                             m_path + QStringLiteral("/controller"));
        m_panel.settings().overrideConnection(choice);
        QObject::connect(&m_link, &link::Link::statusReceived, &m_panel,
                         [this](const link::StatusBatch& batch) {
                             for (const link::StatusSample& sample : batch.samples)
                                 m_statuses.push_back(sample.status);
                         });
        if (!m_panel.load({1024, 600}))
            qFatal("the window cannot be loaded");
        m_touch.theme()->setProperty("animated", false);
        m_panel.window().show();
        m_touch.settle();
        m_panel.open();
    }

    [[nodiscard]] panel::Controller& controller() { return m_panel.controller(); }
    [[nodiscard]] panel::Editor& editor() { return m_panel.editor(); }
    [[nodiscard]] panel::Maintenance& maintenance() { return m_panel.maintenance(); }
    [[nodiscard]] panel::Settings& settings() { return m_panel.settings(); }
    [[nodiscard]] shell::Panel& panel() { return m_panel; }
    [[nodiscard]] QString folder() const { return m_path; }
    [[nodiscard]] looks::TouchDriver& touchDriver() { return m_touch; }
    [[nodiscard]] const std::vector<modbus::StatusBlock>& statuses() const { return m_statuses; }

    void tap(const char* name) { m_touch.tap(QString::fromLatin1(name)); }
    // Holds a key that commands the machine until it acts: a tap does not.
    void hold(const char* name)
    {
        m_touch.touch(QString::fromLatin1(name));
        QTest::qWait(600);
        m_touch.lift();
    }
    void start() { hold("startKey"); }
    // Downloads the recipe from the Motion page, waits until the controller has it and the sheet has closed.
    void download()
    {
        constexpr int timeoutMs = 20'000;
        const panel::ProgramDownload& download = *editor().programDownload();
        QTRY_VERIFY_WITH_TIMEOUT(download.canDownload(), timeoutMs);
        tap("nextStep");
        tap("downloadStart");
        QTRY_COMPARE_WITH_TIMEOUT(download.state(), panel::ProgramDownload::State::Applied, timeoutMs);
        m_touch.settle();
        QVERIFY(!m_touch.find(QStringLiteral("sheetPanel")));
    }
    // Taps digits on the open keypad.
    void tapDigits(const QString& digits)
    {
        for (const QChar digit : digits) {
            QQuickItem* keypad = m_touch.find(QStringLiteral("keypad"));
            QQuickItem* key = keypad ? keyWith(*keypad, digit) : nullptr;
            if (key)
                m_touch.tap(*key);
            else
                m_missing += digit;
        }
    }
    // Returns the items that were missing from the screen when they were needed.
    [[nodiscard]] QStringList complaints() const { return m_touch.complaints() + m_missing; }
    // Returns every text on the screen.
    [[nodiscard]] QString texts() { return textsBelow(m_touch.root()); }

private:
    static QQuickItem* keyWith(QQuickItem& below, QChar digit)
    {
        if (below.inherits("QQuickAbstractButton") && below.property("text").toString() == digit)
            return &below;
        for (QQuickItem* child : below.childItems()) {
            if (QQuickItem* found = keyWith(*child, digit))
                return found;
        }
        return nullptr;
    }
    static QString textsBelow(const QQuickItem& item)
    {
        if (!item.isVisible())
            return {};
        QString texts = item.inherits("QQuickText") ? item.property("text").toString() + u'\n' : QString();
        for (const QQuickItem* child : item.childItems())
            texts += textsBelow(*child);
        return texts;
    }

    QTemporaryDir m_folder;
    QString m_path;
    link::ThreadedLink m_link{nullptr};
    shell::Panel m_panel;
    looks::TouchDriver m_touch{m_panel};
    std::vector<modbus::StatusBlock> m_statuses;
    QStringList m_missing;
};

} // namespace campanel::test
