// SPDX-License-Identifier: Apache-2.0
// Reports a change of the application's language. An object with texts follows it by one call in its
// constructor.
#pragma once

#include <QObject>

namespace campanel::panel {

class LanguageNotifier : public QObject {
    Q_OBJECT

public:
    // Returns the notifier of the application, which owns it.
    [[nodiscard]] static LanguageNotifier* ofApplication();
    // Emits the NOTIFY signals of the object's text properties after each change of the language.
    static void follow(QObject* object);
    // Calls `update` before, which computes the texts that the object stores.
    template <typename Object, typename Update> static void follow(Object* object, Update update)
    {
        connect(ofApplication(), &LanguageNotifier::languageChanged, object, update);
        follow(object);
    }

signals:
    void languageChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    using QObject::QObject;
};

} // namespace campanel::panel
