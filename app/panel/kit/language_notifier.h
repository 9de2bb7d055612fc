// SPDX-License-Identifier: Apache-2.0
// Reports a change of the application's language, after which texts must be created again.
#pragma once

#include <QObject>

namespace campanel::panel {

class LanguageNotifier : public QObject {
    Q_OBJECT

public:
    // Returns the notifier of the application, which owns it.
    [[nodiscard]] static LanguageNotifier* ofApplication();

signals:
    void languageChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    using QObject::QObject;
};

} // namespace campanel::panel
