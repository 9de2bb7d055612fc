// SPDX-License-Identifier: Apache-2.0
// A panel on the demonstration link, operated by a TouchDriver. For captures and the self-test.
#pragma once

#include "tests/looks/demo_link.h"
#include "tests/looks/long_texts.h"
#include "tests/looks/touch_driver.h"
#include "tests/support/network_service.h"
#include "tests/support/stored_recipe.h"
#include "tests/support/time_service.h"
#include "tests/support/unit_service.h"

#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>

namespace campanel::looks {

struct Variant {
    QString language; // from Settings.languages, or "long": longer English texts, see long_texts.h
    QString theme;
    QSize size;
    bool gloves = false;

    [[nodiscard]] bool isLong() const;
    [[nodiscard]] QString name() const; // "light-en-1024x600", "light-en-1024x600-gloves"
};

class TestWindow : public TouchDriver {
public:
    explicit TestWindow(const Variant& variant);

    // Returns false when the window could not be loaded.
    [[nodiscard]] bool isReady() const { return m_isReady; }
    [[nodiscard]] DemoLink& link() { return m_link; }
    [[nodiscard]] test::TimeService& timeService() { return m_timeBus.service; }
    [[nodiscard]] test::NetworkService& networkService() { return m_networkBus.service; }
    [[nodiscard]] test::UnitService& unitService() { return m_unitBus.service; }
    // The folder of the stick, and the signer whose packages the panel accepts.
    [[nodiscard]] QString stick() const { return m_folder.filePath(QStringLiteral("KINGSTON")); }
    [[nodiscard]] const store::SigningKey& signer() const { return m_signer; }
    [[nodiscard]] QString updateState() const { return m_folder.filePath(QStringLiteral("update-state")); }
    // The folder of the touchscreen's files: the rule of its calibration is "rule", see TouchPlaces.
    [[nodiscard]] QString touchFolder() const { return m_folder.filePath(QStringLiteral("touch")); }
    [[nodiscard]] shell::Panel& panel() { return m_panel; }

    using TouchDriver::tap;
    // Taps an item, also one behind a menu. A page without a key in the navigation, as in glove mode on a
    // small screen, is behind the key More. A group of Maintenance without a key is behind the key for all
    // groups, and an input of another group is behind the key to the next one.
    void tap(const QString& name);
    // Sets the level of the person at the panel without users.
    void setLevel(panel::Level level);
    // Updates the age of the machine's data, as its timer does every tenth of a real second.
    void checkClock();
    // Waits until the search has ended.
    void waitFor(panel::CamFiles& files);
    void waitFor(panel::ReportFiles& files);
    // Waits until all requested trends are read; their store must be open.
    void waitForTrends();
    void waitFor(panel::RecipeFiles& files);

    // Waits until `condition` holds; checks it whenever the object emits that signal.
    template <typename Object, typename Signal, typename Condition>
    void waitUntil(Object& object, Signal signal, Condition condition)
    {
        QEventLoop untilTrue;
        QObject::connect(&object, signal, &untilTrue, [&] {
            if (condition(object))
                untilTrue.quit();
        });
        constexpr int patienceMs = 10000;
        QTimer::singleShot(patienceMs, &untilTrue, &QEventLoop::quit);
        if (!condition(object))
            untilTrue.exec();
        if (!condition(object))
            reportError(QStringLiteral("what was waited for did not come"));
        settle();
    }

private:
    void setUpUpdate();
    void setUpTouch();
    template <typename Files> void waitUntilIdle(Files& files);

    QTemporaryDir m_folder;
    std::unique_ptr<LongTexts> m_longTexts; // installed before the panel has any text
    DemoLink m_link{nullptr};
    test::TimeBus m_timeBus;
    test::NetworkBus m_networkBus;
    test::UnitBus m_unitBus;
    store::SigningKey m_signer = store::newSigningKey(QStringLiteral("Anna Plant")).value();
    shell::Panel m_panel;
    bool m_isReady = false;
};

} // namespace campanel::looks
