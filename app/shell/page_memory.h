// SPDX-License-Identifier: Apache-2.0
// The page that is open, in a small file that exists while the panel runs: who finds it at a start knows that
// the last run was not ended in order, and where it was.
#pragma once

#include <QObject>
#include <QQuickWindow>
#include <QString>

#include <optional>

namespace campanel::panel {

class PageMemory : public QObject {
    Q_OBJECT

public:
    // The file need not exist; its folder is made when it is first written.
    explicit PageMemory(const QString& file);
    // The orderly end: the next start begins with the first page.
    ~PageMemory() override;

    // The page that a run left behind which was not ended in order; empty after an orderly end.
    [[nodiscard]] std::optional<int> left() const { return m_left; }
    // From now on the window's property "page" is kept.
    void follow(QQuickWindow& window);

private slots:
    void keep();

private:
    QString m_file;
    std::optional<int> m_left;
    QQuickWindow* m_window = nullptr;
};

} // namespace campanel::panel
