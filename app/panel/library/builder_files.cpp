// SPDX-License-Identifier: Apache-2.0
#include "app/panel/library/builder_files.h"

#include "app/panel/kit/language_notifier.h"
#include "app/panel/library/recipes.h"
#include "app/panel/records/database_service.h"
#include "app/store/files/files.h"

#include <QDir>
#include <QLoggingCategory>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {
Q_LOGGING_CATEGORY(builderLog, "campanel.builder")
}

BuilderFiles::BuilderFiles(Recipes& recipes, DatabaseService& records, QObject* parent)
    : QObject(parent)
    , m_recipes(recipes)
    , m_records(records)
{
    connect(&recipes, &Recipes::listChanged, this, &BuilderFiles::take);
    LanguageNotifier::follow(this, [this] { show(); });
}

void BuilderFiles::open(const QString& folder, const QString& keyFolder, const QStringList& complaints)
{
    m_complaints = complaints;
    m_keyFolder = keyFolder;
    if (QDir(folder).exists())
        m_folder = folder;
    show();
    take();
}

void BuilderFiles::take()
{
    if (m_folder.isEmpty() || !m_recipes.ready())
        return;
    const QString folder = std::exchange(m_folder, {});
    const auto report = store::readBytes(QDir(folder).filePath(u"report"_s)).value_or(QByteArray());
    // A line per file: its name, a tab, and "ok" or why it was not taken.
    for (const QString& line : QString::fromUtf8(report).split(u'\n', Qt::SkipEmptyParts)) {
        const QString file = line.section(u'\t', 0, 0);
        const QString reason = line.section(u'\t', 1);
        if (reason != u"ok") {
            refuse(file, reason);
        } else if (!file.startsWith(u"recipes/")) { // those are taken below
            m_taken << file;
            emit noted({.what = u"builder.file"_s, .object = file});
        }
    }
    m_recipes.takeFromBuilder(QDir(folder).filePath(u"recipes"_s), m_keyFolder,
                              [this, folder](int count, const QMap<QString, QString>& refused) {
                                  for (const auto& [file, reason] : refused.asKeyValueRange())
                                      refuse(file, reason);
                                  m_recipeCount = count;
                                  finish(folder);
                              });
}

void BuilderFiles::refuse(const QString& file, const QString& reason)
{
    m_refused << std::pair(file, reason);
    emit noted({.what = u"builder.file"_s, .object = file, .after = reason, .outcome = u"refused"_s});
}

void BuilderFiles::finish(const QString& folder)
{
    m_records.store().run(
        this, [folder](store::Database&) { return QDir(folder).removeRecursively(); },
        [folder](bool isRemoved) {
            if (!isRemoved) // it is taken again at the next start, which changes nothing
                qCWarning(builderLog) << folder << "cannot be removed";
        });
    show();
}

void BuilderFiles::show()
{
    constexpr qsizetype shown = 2;
    QStringList sentences = m_complaints;
    for (const auto& [file, reason] : std::as_const(m_refused))
        sentences << tr("Not taken from the card: %1. %2", "file, whole sentence").arg(file, reason);
    if (const qsizetype more = sentences.size() - shown; more > 0) {
        sentences.resize(shown);
        sentences << tr("And %n more; the audit trail has all.", "", static_cast<int>(more));
    }
    QStringList taken = m_taken;
    if (m_recipeCount > 0)
        taken << tr("recipes: %1").arg(m_recipeCount);
    if (!taken.isEmpty())
        sentences << tr("Taken from the card: %1.", "list").arg(taken.join(u", "_s));
    if (std::exchange(m_notice, sentences.join(u' ')) != m_notice)
        emit noticeChanged();
}

void BuilderFiles::dismissNotice()
{
    m_complaints.clear();
    m_refused.clear();
    m_taken.clear();
    m_recipeCount = 0;
    show();
}

} // namespace campanel::panel
