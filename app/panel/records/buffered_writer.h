// SPDX-License-Identifier: Apache-2.0
// Writes the changes that a book collects into its log. What could not be written is put back, so that a
// later write contains it; the first failure in a row is reported.
#pragma once

#include "app/panel/records/database_service.h"

#include <functional>
#include <utility>

namespace campanel::panel {

// `Book` has isBegun(), takeChanges() and putBack(); `Log` has write().
template <class Book, class Log> class BufferedWriter {
public:
    using Changes = decltype(std::declval<Book&>().takeChanges());

    // `written` is called after each write, with true when it succeeded. All arguments must outlive the
    // object.
    BufferedWriter(QObject& owner, DatabaseService& records, Book& book,
                   std::function<void(bool)> written = {})
        : m_owner(owner)
        , m_records(records)
        , m_book(book)
        , m_written(std::move(written))
    {
    }
    // Writes the pending changes.
    ~BufferedWriter()
    {
        run(nullptr, [](const auto&, const auto&) {});
    }
    BufferedWriter(const BufferedWriter&) = delete;
    BufferedWriter& operator=(const BufferedWriter&) = delete;

    [[nodiscard]] bool isWriting() const { return m_writes > 0; }
    [[nodiscard]] bool hasFailed() const { return m_hasFailed; } // the last write

    // Writes the changes and returns them; empty: there are none, or the log has not begun.
    Changes write()
    {
        const Changes changes = run(&m_owner, [this](const Changes& tried, const Written& written) {
            --m_writes;
            const bool hadFailed = std::exchange(m_hasFailed, !written);
            if (!written)
                m_book.putBack(tried);
            if (!written && !hadFailed)
                m_records.reportError(written.error());
            if (m_written)
                m_written(written.has_value());
        });
        m_writes += changes.isEmpty() ? 0 : 1;
        return changes;
    }

private:
    using Written = tl::expected<void, store::StoreError>;

    template <typename Done> Changes run(QObject* context, Done done)
    {
        const Changes changes = m_book.isBegun() ? m_book.takeChanges() : Changes();
        if (!changes.isEmpty())
            m_records.store().run(
                context, [changes](store::Database& database) { return Log::write(database, changes); },
                [changes, done](const Written& written) { done(changes, written); });
        return changes;
    }

    QObject& m_owner;
    DatabaseService& m_records;
    Book& m_book;
    std::function<void(bool)> m_written;
    int m_writes = 0; // under way
    bool m_hasFailed = false;
};

} // namespace campanel::panel
