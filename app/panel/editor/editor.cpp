// SPDX-License-Identifier: Apache-2.0
#include "app/panel/editor/editor.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor_views.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/recipe/controller_program.h"
#include "app/panel/recipe/recipe_edit.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/refusal_sentences.h"
#include "app/program/cam_advance.h"
#include "app/store/database/names.h"

#include <QDir>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

using profile::Field;

Level levelFor(Field field)
{
    return profile::info(field).isForOperators ? Level::Operator : Level::Technician;
}

// Returns the level for the change from one recipe to the other: an operator's only when bag length and rate,
// or the confirmed advance, alone differ.
Level levelBetween(const program::Recipe& before, const program::Recipe& after)
{
    program::Recipe same = after;
    program::setConfirmedAdvance(same.program, program::confirmedAdvanceMm(before.program));
    if (!before.isCutter() || !after.isCutter())
        return sameRecipe(before, same) ? Level::Operator : Level::Technician;
    same.cutter().pinned = before.cutter().pinned;
    for (const Field field : profile::cycleFields)
        program::setValue(same, field, program::value(before, field));
    // Ratios that follow are no change of their own.
    if (same.cutter().ratioMode != profile::RatioMode::ByHand)
        same.cutter().k = before.cutter().k;
    return sameRecipe(before, same) ? Level::Operator : Level::Technician;
}

// The delay that combines fast edits: writing a file takes longer than a frame.
constexpr auto keepDelay = 300ms;
constexpr auto tableDelay = 80ms;
constexpr auto restoredTime = 8s; // as long as a message on Recipes

} // namespace

Editor::Editor(Controller& controller, const QString& folder, QObject* parent)
    : QObject(parent)
    , m_knots(this)
    , m_segments(this)
    , m_camFiles(QDir(folder).filePath(u"knots"_s), this)
    , m_map(this)
    , m_ramps(this)
    , m_choices(this)
    , m_laws(this)
    , m_table(this)
    , m_controller(controller)
    , m_download(controller, folder, this)
    , m_storedFile(QDir(folder).filePath(u"recipe.json"_s))
    , m_workingFile(QDir(folder).filePath(u"working_copy.json"_s))
    , m_keepTimer(this)
    , m_tableTimer(this)
{
    const auto stored = m_storedFile.load();
    m_stored = stored.recipe;
    m_recipe = m_stored;
    m_notice = stored.notice;
    m_sources.stored = stored.source;
    if (stored.source == store::LastRecipe::Source::Default)
        m_stored.version = 0;
    loadWorkingCopy();
    m_isNameProposed = m_stored.version == 0 && (m_sources.working == store::LastRecipe::Source::Default ||
                                                 RecipeWords::isProposedName(m_recipe));
    m_camFiles.guardBy(controller.accessCheck());
    connectFields();
    connectKnots();
    connectMap();
    connectRamps();
    m_writer.setMaxThreadCount(1);
    m_keepTimer.setSingleShot(true);
    m_keepTimer.setInterval(keepDelay);
    m_tableTimer.setSingleShot(true);
    m_tableTimer.setInterval(tableDelay);
    connect(&m_tableTimer, &QTimer::timeout, this,
            [this] { takeSolution(solveRecipe(m_recipe, m_identity)); });
    connect(&m_keepTimer, &QTimer::timeout, this, &Editor::keepWorkingCopy);
    connect(&m_download, &ProgramDownload::changed, this, &Editor::overlayChanged);
    connect(&m_download, &ProgramDownload::begun, this, &Editor::downloadBegun);
    connect(&m_download, &ProgramDownload::ended, this, &Editor::downloadEnded);
    connect(&m_download, &ProgramDownload::applied, this, [this](const program::Recipe& recipe) {
        // The library must not know a newer version than the file does.
        takeStored(recipe, [this, recipe] { emit applied(recipe); });
    });
    connect(&controller, &Controller::connectionChanged, this, &Editor::watchController);
    connect(&controller, &Controller::programChanged, this, &Editor::show);
    connect(controller.masterSetting(), &MasterSetting::changed, this, &Editor::show);
    connect(LanguageNotifier::ofApplication(), &LanguageNotifier::languageChanged, this,
            [this] { m_isNameProposed ? recompute() : show(); });
    m_identity = controller.identity();
    recompute();
}

void Editor::connectFields()
{
    for (const profile::FieldInfo& info : profile::fields) {
        const Field field = info.field;
        auto* created = new EditorField(QString::fromLatin1(info.id), this);
        created->setNeededLevel(levelFor(field));
        created->setGroup(QString::fromLatin1(info.group));
        m_fields[static_cast<std::size_t>(field)] = created;
        connect(created, &EditorField::setRequested, this, [this, field](double value) {
            edit(levelFor(field), [&](program::Recipe& recipe) {
                // The grid is that of the metric decimals.
                enterField(recipe, field,
                           item(field)->shown().isConverted() ? value : profile::snapToGrid(field, value));
            });
        });
        connect(created, &EditorField::pinToggleRequested, this, [this, field] {
            edit(Level::Technician, [&](program::Recipe& recipe) { togglePin(recipe, field); });
        });
    }
    const auto connectParameter = [this](EditorField& item, std::size_t index) {
        connect(&item, &EditorField::setRequested, this, [this, index](double value) {
            edit(Level::Technician, [&](program::Recipe& recipe) {
                if (profile::LawParameters* parameters = program::lawParameters(recipe.program))
                    (*parameters)[index] = value;
            });
        });
    };
    connectParameter(m_lawParameter1, 0);
    connectParameter(m_lawParameter2, 1);
}

CamHandles* Editor::handles()
{
    if (std::holds_alternative<profile::PointCamProgram>(m_recipe.program))
        return &m_knots;
    return std::holds_alternative<profile::SegmentCamProgram>(m_recipe.program) ? &m_segments : nullptr;
}

void Editor::connectHandles(CamHandles& handles)
{
    connect(&handles, &CamHandles::edited, this, [this](const profile::Program& program) {
        edit(Level::Technician, [&](program::Recipe& recipe) { recipe.program = program; });
    });
    connect(&handles, &CamHandles::dragged, this, [this](const profile::Program& program) {
        drag(Level::Technician, [&](program::Recipe& recipe) { recipe.program = program; });
    });
    connect(&handles, &CamHandles::dragEnded, this, &Editor::commitDrag);
}

void Editor::connectKnots()
{
    connectHandles(m_knots);
    connectHandles(m_segments);
    connect(&m_camFiles, &CamFiles::taken, this, [this](const profile::Program& program) {
        edit(Level::Technician, [&](program::Recipe& recipe) {
            if (recipe.program.index() == program.index())
                recipe.program = program;
        });
    });
}

void Editor::connectMap()
{
    connect(&m_map, &CutterMap::dragged, this, [this](double lengthMm, double rate) {
        if (!m_recipe.isCutter())
            return;
        drag(Level::Operator, [&](program::Recipe& recipe) {
            enterField(recipe, Field::BagLength, lengthMm);
            enterField(recipe, Field::Rate, rate);
        });
    });
    connect(&m_map, &CutterMap::dragEnded, this, &Editor::commitDrag);
}

void Editor::connectRamps()
{
    connect(&m_ramps, &RampControl::edited, this, [this](const profile::RotaryCutterProgram& program) {
        edit(Level::Technician, [&](program::Recipe& recipe) { recipe.program = program; });
    });
    connect(&m_ramps, &RampControl::dragged, this, [this](const profile::RotaryCutterProgram& program) {
        drag(Level::Technician, [&](program::Recipe& recipe) { recipe.program = program; });
    });
    connect(&m_ramps, &RampControl::dragEnded, this, &Editor::commitDrag);
}

void Editor::follow(program::Recipe& recipe) const
{
    program::Recipe solved = recipe;
    if (m_identity)
        solved.machine = program::withController(recipe.machine, *m_identity);
    program::followRatios(solved);
    recipe.program = solved.program;
}

bool Editor::require(Level needed) const
{
    return m_controller.accessCheck().require(needed);
}

// Changes the recipe as part of a drag; commitDrag() ends the drag.
template <typename Change> void Editor::drag(Level needed, Change change)
{
    if (!m_beforeDrag && !require(needed)) {
        show(); // the handle returns
        return;
    }
    if (!m_beforeDrag)
        m_beforeDrag = m_recipe;
    change(m_recipe);
    follow(m_recipe);
    recompute();
}

template <typename Change> void Editor::edit(Level needed, Change change)
{
    commitDrag();
    if (!require(needed))
        return;
    program::Recipe before = m_recipe;
    change(m_recipe);
    if (!sameRecipe(before, m_recipe)) {
        follow(m_recipe);
        m_history.note(std::move(before));
        m_keepTimer.start();
    }
    recompute();
}

void Editor::setLaw(const QString& lawId)
{
    if (const profile::Law* law = profile::findLaw(lawId.toStdString()))
        edit(Level::Technician, [law](program::Recipe& recipe) { chooseLaw(recipe, *law); });
}

void Editor::newProgram(int kind)
{
    if (kind < 1 || kind > static_cast<int>(program::kinds().size()))
        return;
    edit(Level::Technician,
         [&](program::Recipe& recipe) { recipe = newRecipe(static_cast<profile::ProgramKind>(kind)); });
}

void Editor::setChoice(int row, int option)
{
    if (row >= 0 && row < m_choices.count())
        edit(Level::Technician, [&](program::Recipe& recipe) { m_choices.row(row).apply(option, recipe); });
}

void Editor::compareLaw(const QString& lawId)
{
    const profile::Law* law = profile::findLaw(lawId.toStdString());
    m_comparedLaw = law ? std::optional(law->id) : std::nullopt;
    compareCurves();
    show();
}

// Computes the compared law again; it stays selected while the recipe is edited.
void Editor::compareCurves()
{
    m_comparedCurves.reset();
    const profile::Law* law = m_comparedLaw ? profile::findLaw(*m_comparedLaw) : nullptr;
    if (!law || !hasLaw() || !program::isLawOf(m_recipe.kind(), *law)) {
        m_comparedLaw.reset();
        return;
    }
    program::Recipe other = m_recipe;
    chooseLaw(other, *law);
    follow(other);
    if (const auto solved = program::solveProgram(program::quantised(other)))
        m_comparedCurves =
            std::make_shared<const profile::Curves>(program::sampleCurves(*solved, curvePoints));
}

void Editor::setRecipeName(const QString& name)
{
    const std::string wanted = store::keptName(name).toStdString();
    if (!wanted.empty())
        edit(Level::Technician, [&](program::Recipe& recipe) {
            m_isNameProposed = false;
            recipe.name = modbus::fittingUtf8(wanted, program::longestNameBytes);
        });
}

int Editor::suggestionLevel() const
{
    const profile::Suggestion* wanted = suggestion();
    return static_cast<int>(!wanted          ? Level::Viewer
                            : wanted->ratios ? Level::Technician
                                             : levelFor(wanted->field));
}

void Editor::applySuggestion()
{
    if (!require(Level::Operator) || !suggestion())
        return;
    const profile::Suggestion wanted = *suggestion();
    edit(static_cast<Level>(suggestionLevel()), [&](program::Recipe& recipe) {
        if (wanted.ratios)
            recipe.cutter().k = *wanted.ratios;
        enterField(recipe, wanted.field, wanted.value);
    });
}

void Editor::dragRatio(int index, double timeSeconds)
{
    if (!m_recipe.isCutter() || index < 0 || index >= static_cast<int>(m_recipe.cutter().k.size()))
        return;
    drag(Level::Technician,
         [&](program::Recipe& recipe) { panel::dragRatio(recipe, index, timeSeconds / m_cycleSeconds); });
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

int Editor::undoLevel() const
{
    return canUndo() ? static_cast<int>(levelBetween(m_recipe, m_history.previous())) : -1;
}

int Editor::redoLevel() const
{
    return canRedo() ? static_cast<int>(levelBetween(m_recipe, m_history.next())) : -1;
}

void Editor::undo()
{
    commitDrag();
    if (require(Level::Operator) && canUndo() && require(static_cast<Level>(undoLevel())))
        replace(m_history.undo(m_recipe));
}

void Editor::redo()
{
    commitDrag();
    if (require(Level::Operator) && canRedo() && require(static_cast<Level>(redoLevel())))
        replace(m_history.redo(m_recipe));
}

void Editor::revert()
{
    commitDrag();
    if (!require(Level::Operator) || sameRecipe(m_recipe, m_stored))
        return;
    m_history.note(m_recipe);
    m_comparedLaw.reset();
    replace(m_stored);
    showNotice(tr("Restored the stored recipe %1. Undo brings the edits back.")
                   .arg(QString::fromStdString(m_stored.name)));
    QTimer::singleShot(restoredTime, this, [this, text = m_notice] {
        if (m_notice == text)
            dismissNotice();
    });
}

void Editor::beginTrial()
{
    m_trial = Trial{m_recipe, m_history};
}

void Editor::endTrial(bool isKept)
{
    const std::optional<Trial> trial = std::exchange(m_trial, std::nullopt);
    if (isKept || !trial || sameRecipe(m_recipe, trial->recipe))
        return;
    m_history = trial->history;
    replace(trial->recipe);
}

void Editor::replace(program::Recipe recipe)
{
    m_recipe = std::move(recipe);
    m_keepTimer.start();
    recompute();
}

void Editor::recompute()
{
    if (m_isNameProposed)
        m_recipe.name = RecipeWords::proposedName(m_recipe).toStdString();
    m_recipe.version = edited() ? nextVersion() : m_stored.version;
    m_tableTimer.stop();
    // After a download the recipe is unchanged: its table stays on offer.
    const bool isKnown =
        m_solution.image && sameRecipe(m_solvedFor, m_recipe) && m_solvedFor.version == m_recipe.version;
    m_solvedFor = m_recipe;
    takeSolution(solveRecipe(m_recipe, m_identity, isKnown ? TableWork::All : TableWork::WithoutSlow));
}

void Editor::takeSolution(Solution solution)
{
    m_solution = std::move(solution);
    if (m_solution.isTablePending)
        m_tableTimer.start();
    if (const auto* cutter = m_solution.cutter())
        adopt(m_recipe, cutter->cycle);
    if (m_solution.solved)
        m_cycleSeconds = m_solution.solved->cycleS();
    m_controller.setContactAngle(m_recipe.isCutter() ? m_recipe.machine.contactAngleDeg : 0);
    compareCurves();
    m_table.setImage(m_solution.image);
    m_download.offer(m_solution.image);
    show();
}

void Editor::show()
{
    const auto maxSpeedShare = maxMasterSpeedShare();
    const EditorViews views(m_recipe, m_solution, m_controller.program().get(), maxSpeedShare);
    const program::KindInfo& kind = program::kindInfo(m_recipe.kind());
    for (const auto fields : {kind.programFields, kind.machineFields}) {
        for (const Field field : fields)
            item(field)->show(views.field(field));
    }
    showFields();
    m_choices.setRows(ChoiceRow::rows(m_recipe, m_identity));
    m_map.show(m_recipe, m_solution, m_identity, maxSpeedShare);
    m_ramps.show(m_recipe, m_solution);
    m_knots.show(m_recipe.program, m_cycleSeconds, handles() == &m_knots);
    m_segments.show(m_recipe.program, m_cycleSeconds, handles() == &m_segments);
    m_camFiles.show(m_recipe.program, recipeName());
    m_lawParameter1.show(views.lawParameter(0));
    m_lawParameter2.show(views.lawParameter(1));
    if (m_areLawsWatched)
        m_laws.setRows(views.laws(m_comparedLaw));
    shareMachine();
    emit kindChanged();
    emit overlayChanged();
    emit solutionChanged();
    emit historyChanged();
    emit recipeChanged();
}

std::optional<double> Editor::maxMasterSpeedShare() const
{
    const MasterSetting& setting = *m_controller.masterSetting();
    const bool isLed = m_recipe.master == program::RecipeMaster::Encoder ||
                       (m_recipe.master == program::RecipeMaster::Any && setting.followsEncoder());
    return isLed && program::hasMaster(m_recipe) ? std::optional(setting.maxSpeedShare()) : std::nullopt;
}

// Emits only when the fields themselves change: the list then creates its items again.
void Editor::showFields()
{
    QList<Field> shown;
    for (const Field field : program::kindInfo(m_recipe.kind()).programFields) {
        if (m_recipe.isCutter() || program::isRead(m_recipe.program, field))
            shown << field;
    }
    if (shown == m_shownFields)
        return;
    m_shownFields = shown;
    emit fieldsChanged();
}

void Editor::watchController()
{
    const auto& identity = m_controller.identity();
    const bool isSame = identity.has_value() == m_identity.has_value() &&
                        (!identity || (identity->uniqueId == m_identity->uniqueId &&
                                       identity->timerClockHz == m_identity->timerClockHz &&
                                       identity->rowCapacity == m_identity->rowCapacity &&
                                       identity->tableLayouts == m_identity->tableLayouts));
    if (isSame)
        return;
    m_identity = identity;
    recompute();
}

void Editor::confirmAdvance()
{
    edit(Level::Operator, [](program::Recipe& recipe) { program::confirmAdvance(recipe.program); });
}

void Editor::closeCam()
{
    edit(Level::Technician, [](program::Recipe& recipe) { program::closeCam(recipe.program); });
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

} // namespace campanel::panel
