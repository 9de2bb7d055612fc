// SPDX-License-Identifier: Apache-2.0
#include "tests/looks/screen_lists.h"

#include "tests/looks/test_window.h"

#include <array>
#include <cmath>

namespace campanel::looks {

namespace {

using Step = panel::MarkWizard::Step;

// The controller's report of the line, as registers.
class Packer {
public:
    void set(const char* name, double value)
    {
        const modbus::RegisterInfo& info = *modbus::findRegister(name);
        const auto raw = static_cast<std::uint32_t>(std::llround(value / info.scale));
        const std::size_t at = info.address - modbus::packerAddress;
        if (info.count == 2)
            m_registers[at] = static_cast<std::uint16_t>(raw >> 16U);
        m_registers[at + info.count - 1U] = static_cast<std::uint16_t>(raw & 0xFFFFU);
    }
    void setRaw(const char* name, std::size_t index, unsigned value)
    {
        m_registers[modbus::findRegister(name)->address - modbus::packerAddress + index] =
            static_cast<std::uint16_t>(value);
    }
    void tell(DemoLink& link) const
    {
        constexpr quint32 packingLine = 1; // id of the reader of this group
        const link::ReadRequest request{packingLine, modbus::packerAddress, modbus::packerRegisters()};
        emit link.registersRead({request, link::ReadEnd::Done, m_registers, link.now(), std::nullopt});
    }

private:
    std::vector<std::uint16_t> m_registers = std::vector<std::uint16_t>(modbus::packerRegisters());
};

Packer following()
{
    Packer packer;
    packer.set("packer.mark_state", static_cast<double>(modbus::MarkState::Tracking));
    packer.set("packer.bag_number", 12480);
    packer.set("packer.teach_marks", panel::PackingSetup::marksToTeach);
    packer.set("packer.teach_pitch", 250.31);
    packer.set("packer.teach_scatter", 0.08);
    return packer;
}

void showValues(TestWindow& window, double bags = 12480)
{
    window.link().show(DemoLink::Situation::Running);
    window.checkClock();
    for (const modbus::RegisterInfo& info : modbus::registers()) {
        if (info.name.starts_with("parameter."))
            window.link().exchange({0, std::string(info.name), info.defaultValue});
    }
    Packer packer = following();
    packer.set("packer.bag_number", bags);
    packer.tell(window.link());
    window.settle();
}

// Shows a machine that aligns its cuts after a change of length: no bag counts yet, and the last one is
// scrap.
void showScrap(TestWindow& window)
{
    window.tap(QStringLiteral("nav_run"));
    panel::Controller& controller = window.panel().controller();
    const panel::ControllerProgram program = *controller.program();
    modbus::StatusBlock status = *controller.status();
    ++status.generation;
    controller.run()->announceChange({2, 5, 2, 660, 13.7}, {.fromMm = 200, .toMm = 250});
    emit window.link().statusReceived({{{window.link().now(), status}}, 0});
    emit window.link().programRead({status.generation, program.crc, program.registers, program.list});
    Packer packer;
    packer.set("packer.mark_state", static_cast<double>(modbus::MarkState::Aligning));
    packer.set("packer.bag_number", 1);
    packer.tell(window.link());
    packer.set("packer.bag_number", 2);
    packer.setRaw("packer.bags", 4 * 2 + 3, 1U << 8U | 1U << static_cast<unsigned>(modbus::BagBit::StartUp));
    packer.tell(window.link());
}

// Shows a machine that slows down for a change of length: the controller has the program and waits for the
// boundary.
void showArmedChange(TestWindow& window)
{
    window.tap(QStringLiteral("nav_run"));
    panel::Controller& controller = window.panel().controller();
    const double bagMm = controller.active().bagLengthMm;
    modbus::StatusBlock status = *controller.status();
    status.stagedState = modbus::StagedState::Armed;
    controller.run()->announceChange({2, 2, 0, 0, 4.7}, {.fromMm = bagMm,
                                                         .toMm = bagMm - 60,
                                                         .cutToEndMm = bagMm / 2,
                                                         .endToCutMm = bagMm / 2 - 30,
                                                         .scrap = 2});
    emit window.link().statusReceived({{{window.link().now(), status}}, 0});
    following().tell(window.link());
}

// Shows marks that vary with the film's slip and the sensor's scatter, always the same.
void showSuggestions(TestWindow& window)
{
    constexpr std::array errorsUm{60, -40, 20, 90, -70, 10, -30, 80, -20, -50, 40};
    Packer packer = following();
    for (int mark = 0; mark < 180; ++mark) {
        packer.set("packer.marks", mark);
        packer.set("packer.last_mark", errorsUm[static_cast<std::size_t>(mark) % errorsUm.size()] / 1000.0);
        packer.set("packer.mark_pitch", 250.3);
        packer.tell(window.link());
    }
}

void openSection(TestWindow& window)
{
    window.tap(QStringLiteral("nav_maintenance"));
    window.tap(QStringLiteral("maintenanceMachine"));
    window.tap(QStringLiteral("maintenancePacking"));
    showValues(window);
}

// Opens the edges of a line that has just run: another screen may have changed its program.
void openEdges(TestWindow& window)
{
    window.link().show(DemoLink::Situation::Stopped);
    openSection(window);
    window.tap(QStringLiteral("packingEdges"));
}

void openJamEmpty(TestWindow& window)
{
    window.link().show(DemoLink::Situation::Empty);
    window.checkClock();
    for (const char* name : {"nav_maintenance", "maintenanceMachine", "maintenancePacking", "packingJam"})
        window.tap(QString::fromLatin1(name));
}

// The page of the jams in this state of the monitoring.
Screen jamIn(const char* name, modbus::JamState state, DemoLink::Situation situation)
{
    return {QString::fromLatin1(name), [state, situation](TestWindow& window) {
                openSection(window);
                window.link().setJamState(state);
                window.link().show(situation);
                window.tap(QStringLiteral("packingJam"));
                window.settle();
                window.link().setJamState(modbus::JamState::Armed);
            }};
}

void openWizard(TestWindow& window, Step step)
{
    openSection(window);
    window.tap(QStringLiteral("packingWizard"));
    panel::MarkWizard& wizard = *window.panel().maintenance().packing()->wizard();
    double bags = 12480;
    if (step != Step::Explain) {
        wizard.goOn();
        showValues(window, bags += step == Step::Cutting ? 2 : panel::MarkWizard::bagsToCut);
    }
    if (step == Step::Explain || step == Step::Cutting)
        return;
    for (const double measuredMm : {-3.1, -2.9, -3.05})
        wizard.addMeasurement(measuredMm);
    if (step == Step::Confirm)
        wizard.goOn();
    window.settle();
}

Screen wizardAt(const char* name, Step step)
{
    return {QString::fromLatin1(name), [step](TestWindow& window) { openWizard(window, step); }};
}

} // namespace

QList<Screen> packingScreens()
{
    return {{QStringLiteral("packing-unknown"),
             [](TestWindow& window) {
                 window.link().show(DemoLink::Situation::Empty);
                 window.checkClock();
                 for (const char* name : {"nav_maintenance", "maintenanceMachine", "maintenancePacking"})
                     window.tap(QString::fromLatin1(name));
             }},
            {QStringLiteral("packing"), openSection},
            {QStringLiteral("run-scrap"), showScrap},
            {QStringLiteral("run-change-armed"), showArmedChange},
            {QStringLiteral("packing-suggested"),
             [](TestWindow& window) {
                 openSection(window);
                 showSuggestions(window);
             }},
            {QStringLiteral("packing-keypad"),
             [](TestWindow& window) {
                 openSection(window);
                 window.tap(QStringLiteral("packing1"));
             }},
            {QStringLiteral("packing-edges"), openEdges},
            {QStringLiteral("packing-edges-rejected"),
             [](TestWindow& window) {
                 openEdges(window);
                 window.tap(QStringLiteral("edgesShow"));
             }},
            {QStringLiteral("packing-edges-explained"),
             [](TestWindow& window) {
                 openEdges(window);
                 window.hold(QStringLiteral("edgesExplained"));
             }},
            {QStringLiteral("packing-edges-empty"),
             [](TestWindow& window) {
                 window.link().show(DemoLink::Situation::Empty);
                 window.checkClock();
                 for (const char* name :
                      {"nav_maintenance", "maintenanceMachine", "maintenancePacking", "packingEdges"})
                     window.tap(QString::fromLatin1(name));
             }},
            jamIn("packing-jam", modbus::JamState::Armed, DemoLink::Situation::Running),
            jamIn("packing-jam-seen", modbus::JamState::Armed, DemoLink::Situation::Jammed),
            jamIn("packing-jam-slow", modbus::JamState::TooSlow, DemoLink::Situation::Running),
            {QStringLiteral("packing-jam-empty"), openJamEmpty},
            wizardAt("packing-wizard", Step::Explain),
            wizardAt("packing-wizard-cutting", Step::Cutting),
            wizardAt("packing-wizard-measure", Step::Measure),
            {QStringLiteral("packing-wizard-keypad"),
             [](TestWindow& window) {
                 openWizard(window, Step::Measure);
                 window.tap(QStringLiteral("wizardEnter"));
             }},
            wizardAt("packing-wizard-confirm", Step::Confirm)};
}

} // namespace campanel::looks
