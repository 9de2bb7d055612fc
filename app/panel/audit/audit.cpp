// SPDX-License-Identifier: Apache-2.0
#include "app/panel/audit/audit.h"

#include "app/panel/audit/audit_trail.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/access_sentences.h"

#include <QVariantMap>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

constexpr int checkedAtOnce = 5000; // about ten milliseconds of the database's thread

QVariantMap choice(const QString& key, const QString& text)
{
    return {{u"key"_s, key}, {u"text"_s, text}};
}

} // namespace

Audit::Audit(DatabaseService& records, AuditTrail& trail, QObject* parent)
    : QObject(parent)
    , m_records(records)
    , m_log(records,
            {store::auditTable(), [](const store::AuditRow& row) { return AuditListRow{row}; },
             [this](store::LogFilter& filter) {
                 filter.keysOfWord = AuditWords::keysWith(filter.word);
                 if (!m_who.isEmpty())
                     filter.who = m_who;
                 filter.area = m_area;
             },
             [] { return tr("audit trail"); }},
            this)
{
    connect(&trail, &AuditTrail::appended, &m_log, &AuditPages::add);
    LanguageNotifier::follow(this);
}

void Audit::open()
{
    m_records.store().run(this, &store::auditNames,
                          [this](const tl::expected<QStringList, store::StoreError>& names) {
                              m_names = names.value_or(QStringList());
                              emit changed();
                          });
    m_log.setWatched(false); // reads again
    m_log.setWatched(true);
    check();
}

void Audit::setWho(const QString& who)
{
    m_who = who;
    m_log.restart();
    emit changed();
}

void Audit::setArea(const QString& area)
{
    m_area = area;
    m_log.restart();
    emit changed();
}

void Audit::check()
{
    if (m_isChecking)
        return;
    m_isChecking = true;
    checkNext({});
    emit chainChanged();
}

void Audit::checkNext(store::ChainCheck check)
{
    m_records.store().run(
        this,
        [check](store::Database& database) -> tl::expected<store::ChainCheck, store::StoreError> {
            store::ChainCheck next = check;
            const auto done = next.advance(database, checkedAtOnce);
            return done ? tl::expected<store::ChainCheck, store::StoreError>(next)
                        : tl::unexpected(done.error());
        },
        [this](const tl::expected<store::ChainCheck, store::StoreError>& next) {
            if (next && !next->isOver()) {
                checkNext(*next);
                return;
            }
            m_isChecking = false;
            if (next)
                m_check = *next;
            else
                m_records.reportError(next.error());
            emit chainChanged();
        });
}

bool Audit::broken() const
{
    return m_check && m_check->fault() != store::ChainCheck::Fault::None;
}

QString Audit::chainText() const
{
    if (m_isChecking)
        return tr("Checking the audit trail …");
    return m_check ? AuditWords::chain(*m_check) : tr("Not checked yet.");
}

QString Audit::areaText() const
{
    return AuditWords::area(m_area);
}

QVariantList Audit::names() const
{
    QVariantList names{choice({}, tr("All users"))};
    for (const QString& name : m_names)
        names << choice(name, name);
    return names;
}

QVariantList Audit::areas() const
{
    QVariantList areas{choice({}, AuditWords::area({}))};
    for (const QString& area : AuditWords::areas())
        areas << choice(area, AuditWords::area(area));
    return areas;
}

void Audit::select(int row)
{
    m_selected = row >= 0 && row < rows()->count() ? std::optional(rows()->row(row).row) : std::nullopt;
    emit detailChanged();
}

QString Audit::detailTitle() const
{
    return m_selected ? AuditWords::what(m_selected->entry.what) : QString();
}

QVariantList Audit::detail() const
{
    if (!m_selected)
        return {};
    const store::AuditEntry& entry = m_selected->entry;
    QVariantList lines;
    const auto add = [&](const QString& label, const QString& text) {
        lines << QVariantMap{{u"label"_s, label}, {u"text"_s, text.isEmpty() ? u"--"_s : text}};
    };
    QStringList rowAndTime{QString::number(m_selected->sequence), AuditWords::time(entry.timeMs)};
    if (entry.isClockDoubtful)
        rowAndTime << AlarmWords::clockNote(true);
    add(tr("Row and time"), rowAndTime.join(u" · "_s));
    add(tr("User"),
        u"%1 · %2"_s.arg(AuditWords::who(entry),
                         AccessSentences::level(static_cast<Level>(std::clamp(entry.level, 0, 3)))));
    // The text for the reader, the key for a search in the register document.
    const QString words = AuditWords::object(entry);
    add(tr("Subject"), words == entry.object ? words : u"%1 (%2)"_s.arg(words, entry.object));
    add(tr("Before"), entry.before);
    add(tr("Requested"), entry.after);
    add(tr("Read back"), entry.readBack);
    add(tr("Result"), AuditWords::outcome(entry.outcome));
    add(tr("Hash"), QString::fromLatin1(m_selected->hash.toHex().left(16)));
    return lines;
}

} // namespace campanel::panel
