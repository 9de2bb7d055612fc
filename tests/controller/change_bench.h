// SPDX-License-Identifier: Apache-2.0
// Changes of program while the machine runs: cutters' tables of any shape, and what must be true of the bags
// behind a change.
#pragma once

#include "rig.h"

#include "base/ctl_words.h"

#include <QString>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace campanel::test::change {

using controller::MachineOptions;

inline constexpr double clockHz = 8e6;
inline constexpr std::uint64_t second = 1'000'000;

inline MachineOptions calm()
{
    MachineOptions options;
    options.film.slipMm = 0.0;
    options.film.stretch = 0.0;
    options.film.markNoiseMm = 0.0;
    options.products.scatterMm = 0.0;
    options.products.laySlipMm = 0.0;
    options.products.eyeNoiseMm = 0.0;
    options.products.lengthScatterMm = 0.0;
    options.products.lengthMm = 40.0;
    return options;
}

// Where the knife goes with the film, how fast against it, and how it gets there.
struct Shape {
    double start = 0.4; // share of the cycle
    double end = 0.6;
    double syncRatio = 1.0;
    double dip = 0.0; // share of the base speed that is lost in the middle between two windows
    std::uint16_t knives = 1;
};

// Returns a cutter's table: sealing speed in the window, base speed in the rest of the cycle.
inline BankImage cutter(std::uint32_t bagUm, double bagsPerMin, const Shape& shape = {})
{
    const std::uint32_t pulses = 10000u / shape.knives;
    constexpr std::uint32_t rowCount = 100;
    const auto cycle = static_cast<std::uint32_t>(std::lround(clockHz * 60.0 / bagsPerMin));
    BankImage bank = camBank(10000, shape.knives, cycle, rowCount);
    bank.bagLengthUm = bagUm;
    bank.syncStart = static_cast<std::uint16_t>(std::lround(shape.start * 36000));
    bank.syncEnd = static_cast<std::uint16_t>(std::lround(shape.end * 36000));
    bank.cutAngle = static_cast<std::uint16_t>((bank.syncStart + bank.syncEnd) / 2);
    // Film and knife tip go together in the window; the rest of the turn is spread over the other rows.
    const double width = shape.end - shape.start;
    const double sealing =
        std::min(0.8, shape.syncRatio * width * bagUm * shape.knives / 1000.0 / (2.0 * M_PI * 60.0));
    std::vector<double> weights;
    double outside = 0.0;
    for (std::uint32_t i = 0; i < rowCount; ++i) {
        const double at = (i + 0.5) / rowCount;
        const bool isWindow = at >= shape.start && at < shape.end;
        const double between = std::fmod(at - shape.end + 1.0, 1.0) / (1.0 - width);
        weights.push_back(isWindow ? 0.0 : 1.0 - shape.dip * std::pow(std::sin(M_PI * between), 2));
        outside += weights.back();
    }
    const auto windowRows = static_cast<double>(std::ranges::count(weights, 0.0));
    double sum = 0.0;
    std::int64_t given = 0;
    for (std::uint32_t i = 0; i < rowCount; ++i) {
        sum += weights[i] > 0.0 ? (1.0 - sealing) * weights[i] / outside : sealing / windowRows;
        const std::int64_t upTo = std::lround(sum * pulses);
        bank.rows[i].pulses = static_cast<std::uint16_t>(upTo - given);
        given = upTo;
    }
    return bank;
}

inline void setLimit(Rig& rig, std::uint16_t address, std::uint32_t hz)
{
    QCOMPARE(
        rig.write(address, {static_cast<std::uint16_t>(hz >> 16), static_cast<std::uint16_t>(hz & 0xFFFFu)}),
        0);
}

template <typename Image> void arm(Rig& rig, const Image& bank, std::uint16_t session)
{
    QCOMPARE(rig.download(bank.registers(), session), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(bank.registers(), CTL_APPLY_MODE_NEXT_CYCLE, session), CTL_REFUSAL_NONE);
}

// Returns what is wrong with the bag that was just cut: one that is not called scrap is within tolerance.
inline QString wrongBag(const ctl_packer& packer, const campanel::controller::BagCut& cut,
                        std::uint32_t bagUm)
{
    constexpr double toleranceMm = 0.2;
    constexpr unsigned scrap = 1u << CTL_BAG_BIT_START_UP | 1u << CTL_BAG_BIT_CHANGE_OVER;
    if (cut.throughProduct)
        return QStringLiteral("a cut through a product");
    const unsigned flags = packer.records[CTL_BAG_REGISTERS * (packer.bags % CTL_BAG_RECORDS) + 3];
    if (!cut.lengthUm || (flags & scrap) != 0)
        return {};
    const double deviationMm =
        (static_cast<double>(*cut.lengthUm) - static_cast<double>(ctl_packer_set_um(&packer, bagUm))) / 1000;
    if (std::abs(deviationMm) <= toleranceMm && std::abs(cut.markErrorMm) <= toleranceMm)
        return {};
    return QStringLiteral("%1 mm too long, %2 mm behind its mark").arg(deviationMm).arg(cut.markErrorMm);
}

// Runs on for some bags, of which the last are in register, and stops at the end of a cycle: no phase and no
// pulse is lost, and the products lie in the middle of their bags again.
inline QString wrongAfter(Rig& rig, std::uint32_t bagUm, double productMm = 1.0)
{
    constexpr int bags = 24;
    constexpr int settled = 16;
    const ctl_packer& packer = rig.core().packer;
    double drawnMm = 0.0;
    for (int bag = 0; bag < bags;) {
        rig.controller().step();
        if (rig.core().motion.state != CTL_STATE_RUNNING)
            return QStringLiteral("the run ended: alarms %1").arg(packer.alarms, 0, 16);
        const auto& cut = rig.controller().cut();
        if (!cut)
            continue;
        ++bag;
        const QString wrong = wrongBag(packer, *cut, bagUm);
        if (!wrong.isEmpty())
            return QStringLiteral("bag %1: %2").arg(bag).arg(wrong);
        if (bag > settled && packer.last_cut.scrap)
            return QStringLiteral("bag %1 is still scrap").arg(bag);
        const double middleMm = cut->drawnMm - drawnMm;
        drawnMm = cut->drawnMm;
        for (const auto& product : cut->products) {
            const double offMm = (product.leadMm + product.trailMm) / 2 - (drawnMm - middleMm / 2);
            if (bag > settled && packer.last_cut.bags == 1 && std::abs(offMm) > productMm)
                return QStringLiteral("bag %1: its product is %2 mm off the middle").arg(bag).arg(offMm);
        }
    }
    rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    if (!rig.runUntilState(CTL_STATE_READY))
        return QStringLiteral("no stop");
    if (packer.master != 0 || packer.film.phase != 0 || packer.knife_gate.phase != 0)
        return QStringLiteral("a phase is lost");
    const ctl_bank& bank = *ctl_active_bank(&rig.core().banks);
    const std::int64_t pulses = ctl_get32(&bank.registers[CTL_OFFSET_BANK_CYCLE_PULSES]);
    if (rig.commanded() != pulses * rig.core().motion.cycle_count)
        return QStringLiteral("a pulse is lost");
    return {};
}

} // namespace campanel::test::change
