// SPDX-License-Identifier: Apache-2.0
#include "app/panel/reports/commissioning.h"

#include "app/panel/access/access.h"
#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/units.h"
#include "app/panel/settings/settings.h"
#include "app/panel/words/master_sentences.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/register_words.h"

#include <QCoreApplication>

#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

using Rows = QList<std::pair<QString, QString>>;

} // namespace

QString machineText(const Controller& controller)
{
    const auto& identity = controller.identity();
    const QString text = identity ? Commissioning::tr("Machine with controller %1", "serial number")
                                        .arg(QString::number(identity->uniqueId, 16).toUpper())
                                  : Commissioning::tr("Machine with an unknown controller");
    const QString name = controller.settings().machineName();
    return name.isEmpty() ? text : u"%1 · %2"_s.arg(name, text);
}

QStringList signatureTexts()
{
    return {Commissioning::tr("Machine"), Commissioning::tr("Date"), Commissioning::tr("Name and signature")};
}

namespace {

void addFields(Rows& rows, const QVariantList& fields)
{
    for (const QVariant& each : fields) {
        const auto* field = each.value<EditorField*>();
        if (field->visible())
            rows.append({field->label(), Format::joined(field->text(), field->unit())});
    }
}

} // namespace

Commissioning::Commissioning(Controller& controller, Editor& editor, Access& access, ReportFiles& files,
                             QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_editor(editor)
    , m_access(access)
    , m_files(files)
    , m_wallClock([] { return QDateTime::currentDateTime(); })
    , m_printer([](const ReportData&) { return QByteArray(); })
{
}

void Commissioning::offer()
{
    const ReportData made = data();
    const QByteArray pdf = m_printer(made);
    m_files.offer({{tr("%1 commissioning %2", "name of a file: recipe, date")
                        .arg(m_editor.recipeName(), m_wallClock().toString(u"yyyy-MM-dd HH-mm"_s)),
                    u"pdf"_s, [pdf] { return pdf; }}});
}

QList<ReportCode> Commissioning::codes() const
{
    const program::Recipe& recipe = m_editor.recipe();
    QList<ReportCode> codes{{tr("Code of the recipe"), QString::fromStdString(program::codeOf(recipe))}};
    if (!recipe.filmCode.empty())
        codes.append({tr("Code of the film reel"), QString::fromStdString(recipe.filmCode)});
    return codes;
}

ReportSection Commissioning::recipeSection() const
{
    ReportSection section{tr("Recipe"), {}, {}};
    section.rows.append({tr("Program"), RecipeWords::kindName(m_editor.recipe().kind())});
    addFields(section.rows, m_editor.fields());
    for (const ChoiceRow& choice : m_editor.choices()->rows())
        section.rows.append({choice.name, choice.valueText()});
    if (m_editor.hasLaw())
        section.rows.append({m_editor.lawTitle(), m_editor.lawName()});
    if (m_editor.recipeVersion() > 0 && m_editor.edited())
        section.lines << tr("The recipe has been edited since it was saved or downloaded.");
    return section;
}

ReportSection Commissioning::machineSection() const
{
    ReportSection section{tr("Machine data"), {}, {}};
    addFields(section.rows, m_editor.machineFields());
    return section;
}

ReportSection Commissioning::masterSection() const
{
    ReportSection section{MasterSentences::title(), {}, {}};
    for (const Parameter* each : m_controller.masterSetting()->parameters()) {
        if (!std::isnan(each->lastValue()))
            section.rows.append({MasterSentences::parameter(RegisterWords::name(each->info())),
                                 MasterSentences::value(each->info(), each->lastValue())});
    }
    if (section.rows.isEmpty())
        section.lines << tr("The controller follows its clock.");
    return section;
}

ReportSection Commissioning::verdictSection() const
{
    return {tr("Limits"), {{tr("Peaks"), m_editor.peakText()}}, {m_editor.verdict()}};
}

ReportSection Commissioning::tableSection() const
{
    ReportSection section{tr("Table"), {}, m_editor.table()->summary()};
    if (section.lines.isEmpty())
        section.lines << tr("There is no table: the recipe cannot be downloaded.");
    else
        section.rows.append({tr("Rows"), QString::number(m_editor.table()->rowCount())});
    return section;
}

ReportSection Commissioning::controllerSection() const
{
    ReportSection section{tr("Controller"), {}, {}};
    const auto& identity = m_controller.identity();
    if (identity) {
        section.rows.append({tr("Serial number"), QString::number(identity->uniqueId, 16).toUpper()});
        section.rows.append({tr("Firmware"), QString::fromStdString(identity->firmwareVersion())});
        section.rows.append({tr("Register map"), u"%1.%2"_s.arg(identity->mapMajor).arg(identity->mapMinor)});
        section.rows.append({tr("Connected by"), m_controller.simulated() ? tr("simulated controller")
                                                                          : m_controller.portName()});
    }
    const ProgramProof& proof = *m_editor.programDownload()->proof();
    section.rows.append({tr("Active program"), proof.activeText()});
    section.rows.append({tr("Saved program"), proof.savedText()});
    section.lines << m_editor.programDownload()->controllerText();
    section.lines << (proof.result() == ProgramProof::Result::None
                          ? tr("The active program was not read back for this report.")
                          : proof.text());
    return section;
}

ReportSection Commissioning::bagSection() const
{
    ReportSection section{tr("Last bags"), {}, {}};
    const Format format;
    const auto add = [&](const QString& name, double value, int decimals, const QString& unit) {
        if (!std::isnan(value))
            section.rows.append({name, format.measure(value, decimals, unit)});
    };
    const int bags = m_controller.bags().counted;
    if (bags == 0) {
        section.lines << tr("No bag has been measured yet.");
        return section;
    }
    section.rows.append({tr("Measured"), QString::number(bags)});
    add(tr("Mean length"), m_controller.bags().meanMm, 2, u"mm"_s);
    add(tr("Mean deviation"), m_controller.bags().meanDeviationMm, 3, u"mm"_s);
    add(tr("Standard deviation"), m_controller.bags().scatterMm, 3, u"mm"_s);
    section.rows.append(
        {tr("Within ±%1").arg(format.compactMeasure(m_controller.bags().toleranceMm, 0, 2, u"mm"_s)),
         tr("%1 of %2").arg(m_controller.bags().within).arg(bags)});
    return section;
}

ReportData Commissioning::data() const
{
    ReportData made;
    made.title = tr("Commissioning report");
    made.recipe = m_editor.recipeVersion() == 0
                      ? tr("%1, not saved", "recipe").arg(m_editor.recipeName())
                      : tr("%1 · version %2", "recipe")
                            .arg(m_editor.recipeName(), QString::number(m_editor.recipeVersion()));
    const QString when = Format::second(m_wallClock());
    const QString maker = m_access.userName().isEmpty() ? tr("nobody logged in") : m_access.userName();
    made.footer = tr("%1 · %2 · CamPanel %3", "date, person, version")
                      .arg(when, maker, QCoreApplication::applicationVersion());
    made.pageText = tr("Page %1");
    made.machine = machineText(m_controller);
    made.signatures = signatureTexts();
    made.codes = codes();
    made.sections = {verdictSection(), recipeSection(),     machineSection(), masterSection(),
                     tableSection(),   controllerSection(), bagSection()};
    made.isFeasible = m_editor.feasible();
    made.curvesTitle = tr("Curves of one cycle");
    made.curves = m_editor.plot().curves;
    made.quantities = QStringList{u"velocity"_s, u"acceleration"_s, u"frequency"_s};
    const ShownUnit velocity = Units::of(u"mm/s"_s);
    const ShownUnit acceleration = Units::of(u"m/s²"_s);
    made.titles = QStringList{tr("Velocity, %1").arg(velocity.unit),
                              tr("Acceleration, %1").arg(acceleration.unit), tr("Pulse frequency, kHz")};
    made.factors = {velocity.factor, acceleration.factor, 1};
    made.markerTimes = m_editor.plot().markTimes;
    made.violations = m_editor.plot().violations;
    made.limitVelocity = m_editor.plot().limitVelocity;
    made.limitAcceleration = m_editor.plot().limitAcceleration;
    made.limitFrequency = m_editor.plot().limitFrequency;
    made.limitLabel = tr("limit");
    return made;
}

} // namespace campanel::panel
