// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/language_notifier.h"

#include <QCoreApplication>
#include <QEvent>
#include <QMetaProperty>
#include <QSet>

namespace campanel::panel {

namespace {

// Returns false also for a signal with an argument: it reports an event.
bool isNotifiedText(const QMetaProperty& property)
{
    const int type = property.typeId();
    return (type == QMetaType::QString || type == QMetaType::QStringList ||
            type == QMetaType::QVariantList) &&
           property.hasNotifySignal() && property.notifySignal().parameterCount() == 0;
}

void notifyTexts(QObject* object)
{
    QSet<int> done;
    for (int i = 0; i < object->metaObject()->propertyCount(); ++i) {
        const QMetaProperty property = object->metaObject()->property(i);
        if (!isNotifiedText(property) || done.contains(property.notifySignalIndex()))
            continue;
        done.insert(property.notifySignalIndex());
        property.notifySignal().invoke(object);
    }
}

} // namespace

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

void LanguageNotifier::follow(QObject* object)
{
    connect(ofApplication(), &LanguageNotifier::languageChanged, object, [object] { notifyTexts(object); });
}

bool LanguageNotifier::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::LanguageChange && watched == parent())
        emit languageChanged();
    return QObject::eventFilter(watched, event);
}

} // namespace campanel::panel
