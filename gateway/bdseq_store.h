// SPDX-License-Identifier: Apache-2.0
// The number of the connection, bdSeq, by which hosts know a death of an earlier connection. Kept in a file,
// so that a late death of a killed gateway does not end the next one.
#pragma once

#include "app/store/files/files.h"

#include <QString>

namespace campanel::gateway {

class BdSeqStore {
public:
    // Reads the last number; a missing or damaged file begins with 0.
    explicit BdSeqStore(QString file)
        : m_file(std::move(file))
    {
        const auto bytes = store::readBytes(m_file);
        bool isNumber = false;
        const int last = bytes ? bytes->trimmed().toInt(&isNumber) : 0;
        m_next = isNumber && last >= 0 && last < count ? (last + 1) % count : 0;
    }

    // Returns the number of the next connection, 0 to 255, and keeps it. Without the file it goes on in
    // memory.
    int take()
    {
        const int number = m_next;
        m_next = (m_next + 1) % count;
        if (!m_file.isEmpty())
            (void)store::replaceBytes(m_file, QByteArray::number(number) + '\n');
        return number;
    }

private:
    static constexpr int count = 256;

    QString m_file;
    int m_next = 0;
};

} // namespace campanel::gateway
