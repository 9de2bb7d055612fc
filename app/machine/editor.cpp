// SPDX-License-Identifier: Apache-2.0
#include "app/machine/editor.h"

#include "app/machine/editor_views.h"
#include "app/machine/engine_instances.h"
#include "app/machine/machine.h"
#include "app/machine/recipe_edit.h"
#include "app/machine/recipe_words.h"
#include "app/machine/refusal_sentences.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::machine {

namespace {

using profile::Field;

// Edits that follow one another faster are kept together: writing a file takes longer than a frame.
constexpr auto keepDelay = 300ms;

} // namespace

Editor::Editor(Machine& machine, const QString& folder, QObject* parent)
    : QObject(parent)
    , m_laws(this)
    , m_table(this)
    , m_machine(machine)
    , m_desk(machine, this)
    , m_storedFile(QDir(folder).filePath(u"recipe.json"_s))
    , m_workingFile(QDir(folder).filePath(u"working_copy.json"_s))
    , m_keepTimer(this)
{
    const auto stored = m_storedFile.load();
    m_stored = stored.recipe;
    m_recipe = m_stored;
    m_notice = stored.notice;
    if (QFileInfo::exists(m_workingFile.path())) {
        const auto working = m_workingFile.load();
        m_recipe = working.recipe;
        m_notice = m_notice.isEmpty() ? working.notice : m_notice;
    }
    connectFields();
    m_keepTimer.setSingleShot(true);
    m_keepTimer.setInterval(keepDelay);
    connect(&m_keepTimer, &QTimer::timeout, this, &Editor::keepWorkingCopy);
    connect(&m_desk, &DownloadDesk::changed, this, &Editor::downloadChanged);
    connect(&m_desk, &DownloadDesk::changed, this, &Editor::activeChanged);
    connect(&m_desk, &DownloadDesk::applied, this, &Editor::takeApplied);
    connect(&machine, &Machine::connectionChanged, this, &Editor::watchController);
    connect(&machine, &Machine::programChanged, this, &Editor::show);
    QCoreApplication::instance()->installEventFilter(this);
    m_controller = machine.identity();
    recompute();
}

Editor::~Editor()
{
    if (m_keepTimer.isActive())
        keepWorkingCopy();
}

Editor* Editor::create(QQmlEngine* qmlEngine, QJSEngine*)
{
    return attachedInstance<Editor>(qmlEngine);
}

void Editor::connectFields()
{
    m_fields = {{{&m_bagLength, Field::BagLength},
                 {&m_rate, Field::Rate},
                 {&m_baseSpeed, Field::BaseSpeed},
                 {&m_filmSpeed, Field::FilmSpeed},
                 {&m_k1, Field::K1},
                 {&m_k2, Field::K2},
                 {&m_k3, Field::K3},
                 {&m_k4, Field::K4},
                 {&m_syncRatio, Field::SyncRatio},
                 {&m_rampSlices, Field::SlicesPerRamp},
                 {&m_knifeRadius, Field::KnifeRadius},
                 {&m_knives, Field::Knives},
                 {&m_pulsesPerRev, Field::PulsesPerMotorRev},
                 {&m_gearNumerator, Field::GearNumerator},
                 {&m_gearDenominator, Field::GearDenominator},
                 {&m_maxRpm, Field::MaxMotorRpm},
                 {&m_maxAcceleration, Field::MaxKnifeAcceleration},
                 {&m_maxFrequency, Field::MaxPulseFrequency},
                 {&m_maxRate, Field::MaxRate}}};
    for (const auto& [item, field] : m_fields) {
        connect(item, &EditorField::setRequested, this, [this, field = field](double value) {
            edit([&](program::Recipe& recipe) {
                enterField(recipe, field, profile::snapToGrid(field, value));
            });
        });
        connect(item, &EditorField::pinToggleRequested, this,
                [this, field = field] { edit([&](program::Recipe& recipe) { togglePin(recipe, field); }); });
    }
    const auto connectParameter = [this](EditorField& item, std::size_t index) {
        connect(&item, &EditorField::setRequested, this, [this, index](double value) {
            edit([&](program::Recipe& recipe) { recipe.program.speedLawParameters[index] = value; });
        });
    };
    connectParameter(m_lawParameter1, 0);
    connectParameter(m_lawParameter2, 1);
}

template <typename Change> void Editor::edit(Change change)
{
    commitDrag();
    program::Recipe before = m_recipe;
    change(m_recipe);
    if (!sameRecipe(before, m_recipe)) {
        m_history.note(std::move(before));
        m_keepTimer.start();
    }
    recompute();
}

void Editor::setLaw(const QString& lawId)
{
    if (const profile::Law* law = profile::findLaw(lawId.toStdString()))
        edit([law](program::Recipe& recipe) { chooseLaw(recipe, *law); });
}

void Editor::setRecipeName(const QString& name)
{
    const std::string wanted = name.trimmed().toStdString();
    if (!wanted.empty())
        edit([&](program::Recipe& recipe) {
            recipe.name = modbus::fittingUtf8(wanted, program::longestNameBytes);
        });
}

const profile::Suggestion* Editor::suggestion() const
{
    return m_solution.refusals.empty() || m_solution.refusals.front().nearest.empty()
               ? nullptr
               : &m_solution.refusals.front().nearest.front();
}

void Editor::applySuggestion()
{
    if (!suggestion())
        return;
    const profile::Suggestion wanted = *suggestion();
    edit([&](program::Recipe& recipe) { enterField(recipe, wanted.field, wanted.value); });
}

void Editor::dragRatio(int index, double timeSeconds)
{
    if (index < 0 || index >= static_cast<int>(m_recipe.program.k.size()))
        return;
    if (!m_beforeDrag)
        m_beforeDrag = m_recipe;
    machine::dragRatio(m_recipe, index, timeSeconds / m_cycleSeconds);
    recompute();
}

void Editor::commitDrag()
{
    const std::optional<program::Recipe> before = std::exchange(m_beforeDrag, std::nullopt);
    if (!before || sameRecipe(*before, m_recipe))
        return;
    m_history.note(*before);
    m_keepTimer.start();
    emit historyChanged();
}

void Editor::undo()
{
    commitDrag();
    if (m_history.canUndo())
        replace(m_history.undo(m_recipe));
}

void Editor::redo()
{
    commitDrag();
    if (m_history.canRedo())
        replace(m_history.redo(m_recipe));
}

void Editor::revert()
{
    edit([this](program::Recipe& recipe) { recipe = m_stored; });
}

void Editor::replace(program::Recipe recipe)
{
    m_recipe = std::move(recipe);
    m_keepTimer.start();
    recompute();
}

bool Editor::edited() const
{
    return !sameRecipe(m_recipe, m_stored);
}

void Editor::keepWorkingCopy()
{
    m_keepTimer.stop();
    if (const auto kept = m_workingFile.save(m_recipe); !kept)
        showNotice(store::FileErrorText::describe(kept.error()));
}

void Editor::recompute()
{
    m_recipe.version = edited() ? std::min(m_stored.version + 1, program::largestVersion) : m_stored.version;
    m_solution = solveRecipe(m_recipe, m_controller);
    if (m_solution.cutter) {
        adopt(m_recipe, m_solution.cutter->cycle);
        m_cycleSeconds = m_solution.cutter->cycle.cycleTimeS;
    }
    m_table.setImage(m_solution.image);
    m_desk.offer(m_solution.image);
    show();
}

void Editor::show()
{
    const EditorViews views(m_recipe, m_solution, m_machine.program().get());
    for (const auto& [item, field] : m_fields)
        item->show(views.field(field));
    m_lawParameter1.show(views.lawParameter(0));
    m_lawParameter2.show(views.lawParameter(1));
    m_laws.setRows(views.laws());
    emit solutionChanged();
    emit tableChanged();
    emit historyChanged();
    emit recipeChanged();
}

void Editor::watchController()
{
    const auto& identity = m_machine.identity();
    const bool isSame = identity.has_value() == m_controller.has_value() &&
                        (!identity || (identity->uniqueId == m_controller->uniqueId &&
                                       identity->timerClockHz == m_controller->timerClockHz &&
                                       identity->rowCapacity == m_controller->rowCapacity));
    if (isSame)
        return;
    m_controller = identity;
    recompute();
}

QString Editor::lawName() const
{
    return RecipeWords::lawName(m_recipe.program.speedLaw);
}

QString Editor::verdict() const
{
    return EditorViews(m_recipe, m_solution, nullptr).verdict();
}

Editor::Severity Editor::severity() const
{
    if (!feasible())
        return Severity::Bad;
    return m_solution.isCloseToLimit() ? Severity::Warning : Severity::Good;
}

QString Editor::suggestionText() const
{
    return suggestion() ? RefusalSentences::suggestion(*suggestion()) : QString();
}

QVariant Editor::curves() const
{
    return m_solution.curves ? QVariant::fromValue(m_solution.curves) : QVariant();
}

QVariant Editor::activeCurves() const
{
    return m_machine.targetCurves();
}

QList<double> Editor::ratioTimes() const
{
    QList<double> times;
    for (const double k : m_recipe.program.k)
        times << m_cycleSeconds / k;
    return times;
}

const profile::Machine& Editor::limits() const
{
    return m_solution.cutter ? m_solution.cutter->machine : m_recipe.machine;
}

double Editor::limitVelocity() const
{
    return limits().maxMotorRpm / profile::motorRpmPerMmPerS(limits());
}

double Editor::limitAcceleration() const
{
    return limits().maxKnifeAccelerationMmPerS2;
}

double Editor::limitFrequency() const
{
    return profile::pulseFrequencyLimitHz(limits());
}

QList<QPointF> Editor::violations() const
{
    QList<QPointF> spans;
    for (const profile::Refusal& refusal : m_solution.refusals) {
        for (const profile::TimeSpan& span : refusal.brokenDuring)
            spans << QPointF(span.fromS, span.toS);
    }
    return spans;
}

QString Editor::peakText() const
{
    return EditorViews(m_recipe, m_solution, nullptr).peaks();
}

QStringList Editor::tableSummary() const
{
    return EditorViews(m_recipe, m_solution, nullptr).tableSummary();
}

void Editor::download()
{
    commitDrag();
    if (canDownload() && m_solution.image)
        m_desk.download(*m_solution.image, m_recipe);
}

void Editor::cancelDownload()
{
    m_desk.cancel();
}

void Editor::saveToFlash()
{
    m_desk.save();
}

void Editor::takeApplied(const program::Recipe& recipe)
{
    m_stored = recipe;
    if (const auto kept = m_storedFile.save(m_stored); !kept)
        showNotice(store::FileErrorText::describe(kept.error()));
    m_keepTimer.start();
    recompute();
}

void Editor::showNotice(const QString& text)
{
    m_notice = text;
    emit noticeChanged();
}

void Editor::dismissNotice()
{
    showNotice({});
}

bool Editor::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::LanguageChange && watched == QCoreApplication::instance()) {
        show();
        m_table.setImage(m_solution.image);
        m_desk.update();
    }
    return QObject::eventFilter(watched, event);
}

} // namespace campanel::machine
