// SPDX-License-Identifier: Apache-2.0
// Stores the open page in a small file that exists while the panel runs. A file at the start means that the
// last run was not ended properly, and on which page.
#pragma once

#include <QObject>
#include <QQuickWindow>
#include <QString>

namespace campanel::shell {

class PageMemory : public QObject {
    Q_OBJECT

public:
    // Sets the path. The file need not exist; its folder is created with the first write.
    explicit PageMemory(const QString& file);
    // Ends the run properly: the next start begins with the first page.
    ~PageMemory() override;

    // Returns the name of the page of the last run if it was not ended properly; empty otherwise.
    [[nodiscard]] QString left() const { return m_left; }
    // Stores the window's property "page" from now on.
    void follow(QQuickWindow& window);

private slots:
    void keep();

private:
    QString m_file;
    QString m_left;
    QQuickWindow* m_window = nullptr;
};

} // namespace campanel::shell
