// SPDX-License-Identifier: Apache-2.0
#include "app/panel/audit/audit.h"

#include "app/panel/audit/audit_trail.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/kit/report_files.h"
#include "app/panel/records/database_service.h"
#include "app/panel/words/access_sentences.h"

#include <QVariantMap>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

constexpr int page = 100;
constexpr int checkedAtOnce = 5000; // about ten milliseconds of the database's thread

QVariantMap choice(const QString& key, const QString& text)
{
    return {{u"key"_s, key}, {u"text"_s, text}};
}

} // namespace

Audit::Audit(DatabaseService& records, AuditTrail& trail, ReportFiles& files, QObject* parent)
    : QObject(parent)
    , m_records(records)
    , m_files(files)
{
    connect(&m_rows, &AuditRows::moreRequested, this, &Audit::read);
    connect(&trail, &AuditTrail::appended, this, &Audit::takeAppended);
    connect(&m_editor, &LogFilterEditor::changed, this, [this] {
        if (m_filter != logFilter())
            setFilter(logFilter());
    });
    connect(LanguageNotifier::ofApplication(), &LanguageNotifier::languageChanged, this, &Audit::retranslate);
}

void Audit::open()
{
    m_isOpened = true;
    m_records.store().run(this, &store::auditNames,
                          [this](const tl::expected<QStringList, store::StoreError>& names) {
                              m_names = names.value_or(QStringList());
                              emit changed();
                          });
    setFilter(m_filter);
    check();
}

store::LogFilter Audit::logFilter() const
{
    store::LogFilter filter = m_editor.filter();
    filter.keysOfWord = AuditWords::keysWith(filter.word);
    filter.who = m_filter.who;
    filter.area = m_filter.area;
    return filter;
}

void Audit::setFilter(const store::LogFilter& filter)
{
    m_filter = filter;
    m_rows.clear();
    m_hasAll = false;
    m_isReadAgain = m_isReading;
    if (!m_isReading)
        read();
    emit changed();
}

void Audit::setWho(const QString& who)
{
    m_filter.who = who.isEmpty() ? std::nullopt : std::optional(who);
    setFilter(m_filter);
}

void Audit::setArea(const QString& area)
{
    m_filter.area = area;
    setFilter(m_filter);
}

void Audit::read()
{
    m_isReading = true;
    m_rows.setHasMore(false);
    const qint64 before = m_rows.count() == 0 ? 0 : m_rows.rows().last().sequence();
    m_records.store().run(
        this,
        [filter = m_filter, before](store::Database& database) {
            return store::auditTable().page(database, before, page, filter);
        },
        [this](const Rows& rows) { takeRows(rows); });
    emit changed();
}

void Audit::takeRows(const Rows& rows)
{
    m_isReading = false;
    if (std::exchange(m_isReadAgain, false)) {
        read();
        return;
    }
    if (!rows) {
        m_hasAll = true;
        m_records.reportError(rows.error());
    } else if (rows->isEmpty()) {
        m_hasAll = true;
    } else {
        QList<AuditListRow> read;
        for (const store::AuditRow& row : *rows)
            read << AuditListRow{row};
        m_rows.append(read);
    }
    m_rows.setHasMore(!m_hasAll);
    emit changed();
}

void Audit::takeAppended(const store::AuditRow& row)
{
    const bool isNewer = m_rows.count() == 0 || m_rows.row(0).sequence() < row.sequence;
    if (!m_isOpened || m_isReading || !isNewer || !store::auditTable().includes(m_filter, row))
        return;
    m_rows.insert(0, {{row}});
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

void Audit::exportCsv()
{
    if (m_isExporting)
        return;
    m_isExporting = true;
    emit changed();
    m_records.store().run(
        this,
        [filter = m_filter, dialect = store::spreadsheetDialect()](store::Database& database) {
            return store::auditTable().csv(database, filter, dialect, maxExported);
        },
        [this](const tl::expected<store::LogCsv, store::StoreError>& made) {
            m_isExporting = false;
            if (made)
                m_files.offer({{tr("audit trail"), u"csv"_s, [text = made->bytes] { return text; }}},
                              made->isCut ? tr("Only the newest %1 rows are exported. Set a time by the "
                                               "filter for older ones.")
                                                .arg(maxExported)
                                          : QString());
            else
                m_records.reportError(made.error());
            emit changed();
        });
}

QString Audit::areaText() const
{
    return AuditWords::area(m_filter.area);
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
    m_selected = row >= 0 && row < m_rows.count() ? std::optional(m_rows.row(row).row) : std::nullopt;
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
    add(tr("Action"), words == entry.object ? words : u"%1 (%2)"_s.arg(words, entry.object));
    add(tr("Before"), entry.before);
    add(tr("Requested"), entry.after);
    add(tr("Read back"), entry.readBack);
    add(tr("Result"), AuditWords::outcome(entry.outcome));
    add(tr("Hash"), QString::fromLatin1(m_selected->hash.toHex().left(16)));
    return lines;
}

void Audit::retranslate()
{
    m_filter = logFilter(); // the same word in other texts
    m_rows.refresh();
    emit changed();
    emit detailChanged();
    emit chainChanged();
}

} // namespace campanel::panel
