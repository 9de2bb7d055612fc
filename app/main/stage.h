// SPDX-License-Identifier: Apache-2.0
// A panel on the demonstration link under a finger. For captures and the self-test.
#pragma once

#include "app/main/demo_link.h"
#include "app/main/finger.h"

#include <QTemporaryDir>

namespace campanel::panel {

struct Look {
    QString language;
    QString theme;
    QSize size;

    [[nodiscard]] QString name() const; // "light-en-1024x600"
};

class Stage : public Finger {
public:
    explicit Stage(const Look& look);

    // False when the window could not be loaded.
    [[nodiscard]] bool isReady() const { return m_isReady; }
    [[nodiscard]] DemoLink& link() { return m_link; }
    [[nodiscard]] Panel& panel() { return m_panel; }

    // The machine looks at the age of its data now; by itself it does so every tenth of a real second.
    void lookAtClock();
    // Until it has found what there is.
    void waitFor(machine::KnotFiles& files);
    void waitFor(machine::ReportFiles& files);

private:
    template <typename Files> void waitUntilIdle(Files& files);

    QTemporaryDir m_folder;
    DemoLink m_link{nullptr};
    Panel m_panel;
    bool m_isReady = false;
};

} // namespace campanel::panel
