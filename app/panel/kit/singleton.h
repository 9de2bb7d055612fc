// SPDX-License-Identifier: Apache-2.0
// Assigns a QML engine the objects behind the singletons of this module (Controller, Editor ...). Each engine
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

// The base of a type with QML_SINGLETON: QML gets the object that was assigned to its engine.
template <typename Type> struct Singleton {
    static Type* create(QQmlEngine* engine, QJSEngine* /*engine*/)
    {
        auto* instance = engine->property(instanceKey<Type>()).template value<Type*>();
        if (!instance)
            qFatal("%s was used before attachToEngine() gave it to the engine", instanceKey<Type>());
        QJSEngine::setObjectOwnership(instance, QJSEngine::CppOwnership);
        return instance;
    }
};

} // namespace campanel::panel
