// SPDX-License-Identifier: Apache-2.0
#include "app/shell/page_memory.h"

#include "app/store/files/files.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <cstdio>

namespace campanel::shell {
namespace {

constexpr int pages = 7; // in Frame.qml; larger values are damaged, or of another version

std::optional<int> pageIn(const QString& path)
{
    bool isNumber = false;
    const int page = store::readBytes(path).value_or(QByteArray()).trimmed().toInt(&isNumber);
    return isNumber && page >= 0 && page < pages ? std::optional(page) : std::nullopt;
}

} // namespace

PageMemory::PageMemory(const QString& file)
    : m_file(file)
    , m_left(pageIn(file))
{
}

PageMemory::~PageMemory()
{
    if (m_window)
        QFile::remove(m_file);
}

void PageMemory::follow(QQuickWindow& window)
{
    m_window = &window;
    connect(m_window, SIGNAL(pageChanged()), this, SLOT(keep()));
    keep();
}

void PageMemory::keep()
{
    QDir().mkpath(QFileInfo(m_file).path());
    // Replaced in one step, so that killing the process leaves a complete file. It is not flushed: a power
    // cut may lose it.
    const QString fresh = m_file + QStringLiteral(".new");
    QFile file(fresh);
    if (!file.open(QIODevice::WriteOnly))
        return;
    file.write(QByteArray::number(m_window->property("page").toInt()) + '\n');
    file.close();
    std::rename(QFile::encodeName(fresh).constData(), QFile::encodeName(m_file).constData());
}

} // namespace campanel::shell
