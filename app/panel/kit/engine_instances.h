// SPDX-License-Identifier: Apache-2.0
// Assigns a QML engine the objects behind the singletons of this module (Machine, Editor ...). Each engine
// has its own objects, so that tests run side by side and nothing is global.
#pragma once

#include <QJSEngine>
#include <QQmlEngine>
#include <QVariant>

namespace campanel::panel {

// Returns the name of the engine's dynamic property that holds the instance of a singleton type.
template <typename Type> [[nodiscard]] const char* instanceKey()
{
    return Type::staticMetaObject.className();
}

// Assigns one object per singleton type. The caller keeps the ownership; the objects must outlive the engine.
template <typename... Types> void attachToEngine(QQmlEngine& engine, Types&... instances)
{
    (engine.setProperty(instanceKey<Types>(), QVariant::fromValue(&instances)), ...);
}

template <typename Type> [[nodiscard]] Type* attachedInstance(const QQmlEngine* engine)
{
    auto* instance = engine->property(instanceKey<Type>()).template value<Type*>();
    if (!instance)
        qFatal("%s was used before attachToEngine() gave it to the engine", instanceKey<Type>());
    QJSEngine::setObjectOwnership(instance, QJSEngine::CppOwnership);
    return instance;
}

} // namespace campanel::panel
