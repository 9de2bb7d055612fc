// SPDX-License-Identifier: Apache-2.0
// A cutter behind an encoder in either place: on the line's shaft, or on a wheel on film that somebody else
// drives.
#pragma once

#include "rig.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace campanel::test::place {

inline constexpr std::uint32_t cycleTicks = 8'000'000; // 60 a minute
inline constexpr std::int64_t knifePulses = 10'000;    // a cycle
inline constexpr double bagMm = 250.0;
inline constexpr std::uint16_t touchesCentiDeg =
    2500; // the simulated jaws touch within 20 degrees of the cut

inline controller::MachineOptions onLine(bool drivesFilm)
{
    controller::MachineOptions options;
    options.shaft.counts = 10'000;
    options.shaft.speedMmPerS = bagMm;
    options.shaft.drivesFilm = drivesFilm;
    return options;
}

class Line : public Rig {
public:
    explicit Line(bool drivesFilm, controller::MachineOptions options = {}, std::uint32_t ticks = cycleTicks)
        : Rig(options.shaft.counts == 0 ? onLine(drivesFilm) : options)
    {
        BankImage bank = camBank(knifePulses, 1, ticks);
        bank.bagLengthUm = 250'000;
        install(bank);
        write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
        write(CTL_REG_MASTER_PLACE,
              {static_cast<std::uint16_t>(drivesFilm ? CTL_MASTER_PLACE_WHEEL : CTL_MASTER_PLACE_SHAFT)});
        setParameter(CTL_REG_PARAMETER_JAWS_BEFORE, touchesCentiDeg);
        setParameter(CTL_REG_PARAMETER_JAWS_BEHIND, touchesCentiDeg);
        run(500'000);
    }

    controller::LineShaft& shaft() { return controller().machine().shaft(); }
    bool engages()
    {
        for (int i = 0; i < 2000 && status(CTL_REG_MASTER_STATUS_STATE) != CTL_MASTER_STATE_ENGAGED; ++i)
            run(10'000);
        return status(CTL_REG_MASTER_STATUS_STATE) == CTL_MASTER_STATE_ENGAGED;
    }
    // Cuts so many bags; returns the largest deviation of one that is no scrap, infinite when the machine
    // does not cut them in ten times their time, and counts those that are.
    double cutBags(int bags)
    {
        double largest = 0.0;
        scrap = 0;
        const std::uint64_t until = controller().nowUs() + 10'000'000u * static_cast<unsigned>(bags);
        for (int i = 0; i < bags;) {
            controller().step();
            if (controller().nowUs() > until)
                return std::numeric_limits<double>::infinity();
            const auto& cut = controller().cut();
            if (!cut || !cut->lengthUm)
                continue;
            ++i;
            const bool isScrap = ctl_packer_bag_class(&core().packer) != CTL_BAG_GOOD;
            scrap += isScrap ? 1 : 0;
            const double lengths = core().packer.last_cut.bags;
            if (!isScrap)
                largest = std::max(largest, std::abs(*cut->lengthUm / 1000.0 - lengths * bagMm));
        }
        return largest;
    }
    bool mayRun() { return (status(CTL_REG_IO_OUTPUTS) & 1u << CTL_OUTPUT_BIT_LINE_MAY_RUN) != 0; }
    bool jawsAreClosed() { return controller().machine().areJawsClosed(); }
    // Stops the line so that it stands with the jaws on the film.
    bool standsClosed()
    {
        for (int attempt = 0; attempt < 100; ++attempt) {
            shaft().setSpeed(0.0);
            run(560'000); // before the knife opens
            if (jawsAreClosed())
                return true;
            shaft().setSpeed(bagMm);
            run(1'000'000u + static_cast<unsigned>(attempt) * 61'000u);
        }
        return false;
    }
    int scrap = 0;
};

} // namespace campanel::test::place
