// SPDX-License-Identifier: Apache-2.0
// Reports written as new files to a stick or to the panel's own folder.
#pragma once

#include "app/panel/kit/file_exchange.h"
#include "app/store/files/new_file.h"

#include <functional>

namespace campanel::panel {

struct ReportFile {
    QString name; // readable name; see store::freePath()
    QString suffix;
    std::function<QByteArray()> content; // called in another thread
    store::FileWriter write{};           // for large files, instead of `content`
};

// Returns a CSV file with this content, which is kept compressed until a place is chosen.
[[nodiscard]] ReportFile csvFile(const QString& name, const QByteArray& content);

class ReportFiles : public campanel::panel::FileExchange {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Report files belong to Maintenance")
    Q_PROPERTY(campanel::panel::RowModelBase* places READ places CONSTANT FINAL)

public:
    ReportFiles(const QString& ownFolder, QObject* parent);

    using FileExchange::Written; // of one place

    // Replaces the search of this computer's disks, for tests and captures.
    void setScanner(Scanner scanner) { m_scanner = std::move(scanner); }
    // Sets the files to write; clears the last message and searches for places. `notice` tells what they lack
    // and what to do, whole sentences.
    void offer(QList<ReportFile> files, const QString& notice = {});

    [[nodiscard]] OfferModel* places() { return &m_places; }

    // Writes new files to that place, then searches again.
    Q_INVOKABLE void write(int place);

private:
    [[nodiscard]] std::function<Apply()> searcher() override;

    Scanner m_scanner;
    OfferModel m_places{this};
    QList<store::Place> m_found;
    QList<ReportFile> m_files;
    QString m_notice;
};

} // namespace campanel::panel
