// SPDX-License-Identifier: Apache-2.0
#include "app/panel/library/recipe_audit.h"

#include "app/store/recipes/recipe_json.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMap>
#include <QStringList>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

QString valueText(const QJsonValue& value)
{
    if (value.isString())
        return value.toString();
    if (value.isArray()) // the knots or segments of a cam
        return QString::fromUtf8(QJsonDocument(value.toArray()).toJson(QJsonDocument::Compact));
    return value.toVariant().toString();
}

void flatten(const QString& prefix, const QJsonObject& object, QMap<QString, QString>& values)
{
    for (auto each = object.begin(); each != object.end(); ++each) {
        if (each->isObject())
            flatten(prefix + each.key() + u'.', each->toObject(), values);
        else
            values[prefix + each.key()] = valueText(*each);
    }
}

QMap<QString, QString> valuesOf(const program::Recipe& recipe)
{
    QMap<QString, QString> values;
    flatten({}, QJsonDocument::fromJson(store::toJson(recipe)).object(), values);
    values.remove(u"version"_s);
    values.remove(u"name"_s);
    return values;
}

QString version(const store::RecipeVersion& of, const QStringList& values)
{
    const QString number = u"version %1"_s.arg(of.version);
    return values.isEmpty() ? number : u"%1: %2"_s.arg(number, values.join(u", "_s));
}

} // namespace

store::AuditEntry recipeSaved(const std::optional<store::RecipeVersion>& before,
                              const store::RecipeVersion& kept, const QString& signer)
{
    store::AuditEntry entry{.what = before ? u"recipe.save"_s : u"recipe.new"_s,
                            .object = QString::fromStdString(kept.recipe.name),
                            .readBack = u"version %1"_s.arg(kept.version)};
    if (!signer.isEmpty())
        entry.readBack += u", signed by "_s + signer;
    QStringList old;
    QStringList wanted;
    if (before) {
        const QMap<QString, QString> left = valuesOf(before->recipe);
        const QMap<QString, QString> right = valuesOf(kept.recipe);
        for (auto each = left.begin(); each != left.end(); ++each) {
            if (right.value(each.key()) != each.value())
                old << each.key() + u' ' + each.value();
        }
        for (auto each = right.begin(); each != right.end(); ++each) {
            if (left.value(each.key()) != each.value())
                wanted << each.key() + u' ' + each.value();
        }
        entry.before = version(*before, old);
    }
    entry.after = version(kept, wanted);
    return entry;
}

} // namespace campanel::panel
