// SPDX-License-Identifier: Apache-2.0
#include "app/panel/download/window_reason.h"

#include "app/panel/controller/controller.h"
#include "app/panel/words/refusal_sentences.h"
#include "app/store/database/names.h"
#include "app/store/files/files.h"

#include <QDateTime>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

QString idOf(profile::Field field)
{
    const std::string_view id = profile::info(field).id;
    return QString::fromLatin1(id.data(), static_cast<qsizetype>(id.size()));
}

QString textOf(const std::vector<program::Excess>& values)
{
    QStringList texts;
    for (const program::Excess& each : values)
        texts << RefusalSentences::outside(each);
    return texts.join(u" · "_s);
}

// Returns the time of today, or day and time of another day.
QString sinceText(qint64 ms)
{
    const QDateTime since = QDateTime::fromMSecsSinceEpoch(ms);
    return since.date() == QDate::currentDate() ? Format::local(since, u"HH:mm"_s) : Format::minute(since);
}

QJsonArray jsonOf(const std::vector<program::Excess>& values)
{
    QJsonArray array;
    for (const program::Excess& each : values)
        array << QJsonObject{{u"field"_s, idOf(each.field)},
                             {u"value"_s, each.value},
                             {u"min"_s, each.window.min},
                             {u"max"_s, each.window.max}};
    return array;
}

std::vector<program::Excess> valuesIn(const QJsonArray& array)
{
    std::vector<program::Excess> values;
    for (const QJsonValue& each : array) {
        const std::string id = each[u"field"_s].toString().toStdString();
        const auto info = std::ranges::find(profile::fields, std::string_view(id), &profile::FieldInfo::id);
        if (info != profile::fields.end())
            values.push_back({info->field,
                              each[u"value"_s].toDouble(),
                              {each[u"min"_s].toDouble(), each[u"max"_s].toDouble()}});
    }
    return values;
}

} // namespace

WindowReason::WindowReason(Controller& controller, const QString& folder, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_path(QDir(folder).filePath(u"window_reasons.json"_s))
{
    load();
}

// A file that cannot be read has no reason: the line says so.
void WindowReason::load()
{
    const auto bytes = store::readBytes(m_path);
    const QJsonArray array = bytes ? QJsonDocument::fromJson(*bytes).array() : QJsonArray();
    for (const QJsonValue& each : array)
        m_given << Given{static_cast<quint32>(each[u"crc"_s].toInteger()), each[u"since_ms"_s].toInteger(),
                         each[u"by"_s].toString(), each[u"reason"_s].toString(),
                         valuesIn(each[u"values"_s].toArray())};
}

void WindowReason::keep() const
{
    QJsonArray array;
    for (const Given& each : m_given)
        array << QJsonObject{{u"crc"_s, static_cast<qint64>(each.crc)},
                             {u"since_ms"_s, each.sinceMs},
                             {u"by"_s, each.by},
                             {u"reason"_s, each.reason},
                             {u"values"_s, jsonOf(each.values)}};
    // Without the file a restart of the panel forgets the reason; the audit trail has it.
    (void)store::replaceBytes(m_path, QJsonDocument(array).toJson());
}

void WindowReason::setWanted(const program::Recipe* recipe)
{
    auto outside = recipe ? program::outsideWindows(*recipe) : std::vector<program::Excess>();
    if (recipe)
        m_recipeName = QString::fromStdString(recipe->name);
    if (std::exchange(m_outside, std::move(outside)) != m_outside)
        m_reason.clear();
}

void WindowReason::setRunning(bool isRunning)
{
    m_isRunning = isRunning;
    const auto& status = m_controller.status();
    // The windows of what runs were widened.
    if (isRunning && m_outside.empty() && status &&
        m_given.removeIf([&](const Given& each) { return each.crc == status->activeCrc; }) > 0)
        keep();
    emit changed();
}

const WindowReason::Given* WindowReason::givenForActive() const
{
    const auto& status = m_controller.status();
    const auto found = std::ranges::find_if(m_given, [&](const Given& each) {
        return status && status->activeCrc && each.crc == status->activeCrc;
    });
    return found == m_given.end() ? nullptr : &*found;
}

bool WindowReason::isUnexplained() const
{
    return m_isRunning && !m_outside.empty() && !givenForActive();
}

QString WindowReason::question() const
{
    return isMissing() ? tr("Outside the approved window: %1. Give a reason, or enter an approved value.")
                             .arg(textOf(m_outside))
                       : QString();
}

QString WindowReason::line() const
{
    if (const Given* given = givenForActive()) {
        const QString values = textOf(given->values);
        const QString since = sinceText(given->sinceMs);
        return given->by.isEmpty()
                   ? tr("%1: since %2, %3", "values, time, reason").arg(values, since, given->reason)
                   : tr("%1: by %2 since %3, %4", "values, person, time, reason")
                         .arg(values, given->by, since, given->reason);
    }
    return isUnexplained() ? tr("%1: no reason given.", "values").arg(textOf(m_outside)) : QString();
}

QString WindowReason::problem(const QString& text) const
{
    const QString reason = text.simplified();
    if (reason.isEmpty())
        return tr("Enter the reason for the audit trail.");
    if (reason.size() > maxLength)
        return tr("A reason has at most %1 characters. Shorten it.").arg(maxLength);
    if (store::hiddenCharacter(reason))
        return tr("The reason has characters that nobody can see. Remove them.");
    return {};
}

void WindowReason::give(const QString& text)
{
    if (!m_controller.accessCheck().require(Level::Operator) || m_outside.empty() || !problem(text).isEmpty())
        return;
    m_reason = text.simplified();
    m_by = m_controller.accessCheck().person();
    if (isUnexplained()) {
        add(*m_controller.status()->activeCrc);
        keep();
    }
    emit given();
}

void WindowReason::add(quint32 crc)
{
    m_given.removeIf([crc](const Given& each) { return each.crc == crc; });
    m_given << Given{crc, QDateTime::currentMSecsSinceEpoch(), m_by, m_reason, m_outside};
    for (const program::Excess& each : m_outside) {
        const QString id = idOf(each.field);
        const auto number = [&each](double value) {
            return QString::number(value, 'f', profile::info(each.field).decimals);
        };
        emit noted({.what = u"recipe.outside"_s,
                    .object = m_recipeName,
                    .before = u"%1 %2..%3"_s.arg(id, number(each.window.min), number(each.window.max)),
                    .after = u"%1 %2: %3"_s.arg(id, number(each.value), m_reason)});
    }
}

void WindowReason::begin(quint32 crc)
{
    const auto& status = m_controller.status();
    m_given.removeIf([&](const Given& each) { return !status || each.crc != status->activeCrc; });
    if (!m_outside.empty())
        add(crc);
    keep();
}

void WindowReason::end(quint32 crc)
{
    m_given.removeIf([crc](const Given& each) { return each.crc != crc; });
    m_reason.clear(); // the next download asks again
    keep();
}

} // namespace campanel::panel
