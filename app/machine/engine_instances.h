// SPDX-License-Identifier: Apache-2.0
// Gives a QML engine the objects behind the singletons Machine, Editor, Records, Service and Settings. Each engine has
// its own, so that tests run side by side and nothing is global.
#pragma once

#include <QJSEngine>
#include <QQmlEngine>
#include <QVariant>

namespace campanel::machine {

class Editor;
class Machine;
class Records;
class Service;
class Settings;

// The objects stay owned by the caller and must outlive the engine.
void attachToEngine(QQmlEngine& engine, Machine& machine, Editor& editor, Records& records,
                    Service& service, Settings& settings);

// Name of the engine's dynamic property that holds the instance of a singleton type.
template <typename Type> [[nodiscard]] const char* instanceKey()
{
    return Type::staticMetaObject.className();
}

template <typename Type> [[nodiscard]] Type* attachedInstance(const QQmlEngine* engine)
{
    auto* instance = engine->property(instanceKey<Type>()).template value<Type*>();
    if (!instance)
        qFatal("%s was used before attachToEngine() gave it to the engine", instanceKey<Type>());
    QJSEngine::setObjectOwnership(instance, QJSEngine::CppOwnership);
    return instance;
}

} // namespace campanel::machine
