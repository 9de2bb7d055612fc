// SPDX-License-Identifier: Apache-2.0
// A panel on the demonstration link under a finger.
#pragma once

#include "tests/looks/demo_link.h"
#include "tests/looks/finger.h"
#include "tests/looks/long_texts.h"

#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>

namespace campanel::looks {

struct Look {
    QString language; // of Settings.languages, or "long": English texts that are longer, see long_texts.h
    QString theme;
    QSize size;
    bool gloves = false;

    [[nodiscard]] bool isLong() const;
    [[nodiscard]] QString name() const; // "light-en-1024x600", "light-en-1024x600-gloves"
};

class Stage : public Finger {
public:
    explicit Stage(const Look& look);

    // False when the window could not be loaded.
    [[nodiscard]] bool isReady() const { return m_isReady; }
    [[nodiscard]] DemoLink& link() { return m_link; }
    [[nodiscard]] panel::Panel& panel() { return m_panel; }

    using Finger::tap;
    // A page whose key is not in the navigation, as in glove mode on a small screen, is behind the key More;
    // a group of Service that has no key of its own, behind that for all groups.
    void tap(const QString& name);
    // The machine looks at the age of its data now; by itself it does so every tenth of a real second.
    void lookAtClock();
    // Until it has found what there is.
    void waitFor(machine::KnotFiles& files);
    void waitFor(machine::ReportFiles& files);
    // Until it has read what it was asked for so far; its store must be open.
    void waitForTrends();
    void waitFor(machine::RecipeFiles& files);

    // Until `condition` holds, looked at whenever the object emits that signal.
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
            complain(QStringLiteral("what was waited for did not come"));
        settle();
    }

private:
    template <typename Files> void waitUntilIdle(Files& files);

    QTemporaryDir m_folder;
    std::unique_ptr<LongTexts> m_longTexts; // installed before the panel has any text
    DemoLink m_link{nullptr};
    panel::Panel m_panel;
    bool m_isReady = false;
};

} // namespace campanel::looks
