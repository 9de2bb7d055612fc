// SPDX-License-Identifier: Apache-2.0
// A controller with its machine for the fuzzers: a good program of any kind and layout, and a watch over the
// pulses. Each pulse must lie in its slice, in the order of time, and no slice may ask for more than the
// output stage gives.
#pragma once

#include "tests/controller/rig.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/support/cam_image.h"
#include "tests/support/interval_image.h"
#include "tests/support/press_image.h"

#include <cstdint>

namespace campanel::fuzz {

class FuzzMachine {
public:
    using Image = test::Registers;

    // Returns the number of good programs.
    static std::uint8_t images() { return 8; }
    // Returns one of them, of small size.
    static Image image(std::uint8_t index)
    {
        switch (index % images()) {
        case 0:
            return test::camBank(10'000, 2, 8'000'000, 20).registers();
        case 1:
            return test::sineCam(10'000, 500, 16, 8'000'000).registers();
        case 2: {
            test::CamImage cam = test::sineCam(10'000, 500, 16, 8'000'000);
            cam.kind = CTL_PROGRAM_KIND_SEGMENT_CAM;
            cam.segments = 3;
            return cam.registers();
        }
        case 3:
            return test::quinticMove(20'000, 16, 8'000'000).registers();
        case 4:
            return test::speedMove(20'000, 16, 8'000'000).registers();
        case 5:
            return test::trapezoidMove().registers();
        case 6:
            return test::rampAndHold().registers();
        default:
            return test::PressImage{}.registers();
        }
    }

    explicit FuzzMachine(std::uint8_t index)
        : m_image(image(index))
    {
        m_rig.controller().onPulses = [this](const ctl_train& train) { watch(train); };
    }

    [[nodiscard]] test::Rig& rig() { return m_rig; }

    // Downloads the good program and sets off with it; it may still be homing.
    void installAndStart()
    {
        m_rig.install(m_image);
        (void)m_rig.exchange(commandFrame(CTL_COMMAND_START, 0, 0, 0));
    }

    // Returns a command with the next counter.
    test::Bytes commandFrame(std::uint16_t code, std::uint16_t first, std::uint16_t second,
                             std::uint32_t third)
    {
        test::Bytes bytes{1, 16};
        const auto append = [&bytes](unsigned value) {
            bytes.push_back(static_cast<std::uint8_t>(value >> 8));
            bytes.push_back(static_cast<std::uint8_t>(value));
        };
        append(CTL_REG_COMMAND_COUNTER);
        append(CTL_GROUP_COMMAND);
        bytes.push_back(2 * CTL_GROUP_COMMAND);
        append(m_counter++);
        append(code);
        append(first);
        append(second);
        append(third >> 16);
        append(third & 0xFFFFu);
        return test::frame(bytes);
    }

private:
    void watch(ctl_train train)
    {
        const ctl_board& board = m_rig.core().board;
        if (board.tick != m_slice) {
            m_slice = board.tick;
            m_lastTick = 0;
            m_pulses = 0;
        }
        // One pulse may be left over from the slice before, and one that a change of row brings nearer.
        const std::uint64_t most =
            std::uint64_t{board.slice_ticks} * board.config.max_pulse_hz / board.config.timer_clock_hz + 2;
        m_pulses += train.count;
        require(m_pulses <= most, "a slice has no more pulses than the output stage gives");
        require(train.direction == 1 || train.direction == -1, "a pulse has a direction");
        while (train.count != 0) {
            const std::uint32_t tick = ctl_train_next(&train) - m_slice;
            if (tick > board.slice_ticks || tick < m_lastTick)
                std::fprintf(stderr, "tick %u after %u in a slice of %u\n", tick, m_lastTick,
                             board.slice_ticks);
            require(tick <= board.slice_ticks, "a pulse lies in its slice");
            require(tick >= m_lastTick, "pulses are in the order of time");
            m_lastTick = tick;
        }
    }

    Image m_image;
    test::Rig m_rig;
    std::uint16_t m_counter = 0x4000;
    std::uint32_t m_slice = 0xFFFFFFFFu;
    std::uint32_t m_lastTick = 0;
    std::uint64_t m_pulses = 0;
};

} // namespace campanel::fuzz
