// SPDX-License-Identifier: Apache-2.0
// Gives a QML engine the objects behind the singletons of this module (Machine, Editor ...). Each engine has
// its own, so that tests run side by side and nothing is global.
#pragma once

#include <QJSEngine>
#include <QQmlEngine>
#include <QVariant>

namespace campanel::machine {

// Name of the engine's dynamic property that holds the instance of a singleton type.
template <typename Type> [[nodiscard]] const char* instanceKey()
{
    return Type::staticMetaObject.className();
}

// One object per singleton type. They stay owned by the caller and must outlive the engine.
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

} // namespace campanel::machine
