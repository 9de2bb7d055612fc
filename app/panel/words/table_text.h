// SPDX-License-Identifier: Apache-2.0
// A table of any kind in words: its columns, rows and error figures.
#pragma once

#include "app/program/program_image.h"

#include <QCoreApplication>
#include <QStringList>

#include <vector>

namespace campanel::machine {

class TableText {
    Q_DECLARE_TR_FUNCTIONS(TableText)

public:
    // The image must outlive it.
    explicit TableText(const program::ProgramImage& image)
        : m_image(image)
    {
    }

    [[nodiscard]] QString name() const;
    [[nodiscard]] QStringList columns() const;
    // Beginning of each row on the time axis; of a press 0 for all, as its stages end where they end.
    [[nodiscard]] std::vector<double> startsS() const;
    [[nodiscard]] QStringList cells(std::size_t row, double startS) const;
    // What the table says of its own errors, a line each.
    [[nodiscard]] QStringList summary() const;

private:
    [[nodiscard]] QStringList summaryOf(const profile::StepTable& table) const;
    [[nodiscard]] QStringList summaryOf(const profile::CamTable& table) const;
    [[nodiscard]] QStringList summaryOf(const profile::IntervalTable& table) const;
    [[nodiscard]] QStringList summaryOf(const profile::PressTable& table) const;
    [[nodiscard]] QString stretchName(double timeS) const;

    const program::ProgramImage& m_image;
};

} // namespace campanel::machine
