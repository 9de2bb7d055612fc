// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/language_notifier.h"

#include <QCoreApplication>
#include <QEvent>

namespace campanel::panel {

LanguageNotifier* LanguageNotifier::ofApplication()
{
    QCoreApplication* application = QCoreApplication::instance();
    auto* notifier = application->findChild<LanguageNotifier*>({}, Qt::FindDirectChildrenOnly);
    if (!notifier) {
        notifier = new LanguageNotifier(application);
        application->installEventFilter(notifier);
    }
    return notifier;
}

bool LanguageNotifier::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::LanguageChange && watched == parent())
        emit languageChanged();
    return QObject::eventFilter(watched, event);
}

} // namespace campanel::panel
