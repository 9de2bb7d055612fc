// SPDX-License-Identifier: Apache-2.0
// `Editor` in QML: the recipe being edited, its demands on the machine, and its download to the controller.
#pragma once

#include "app/panel/download/program_download.h"
#include "app/panel/editor/cam_files.h"
#include "app/panel/editor/cutter_map.h"
#include "app/panel/editor/edit_history.h"
#include "app/panel/editor/editor_values.h"
#include "app/panel/editor/knot_model.h"
#include "app/panel/editor/ramp_control.h"
#include "app/panel/editor/segment_model.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/recipe/choice_model.h"
#include "app/panel/recipe/law_model.h"
#include "app/panel/recipe/solution.h"
#include "app/panel/recipe/table_model.h"
#include "app/store/recipes/last_recipe.h"
#include "profile/program/programs.h"

#include <QObject>
#include <QPointF>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <array>
#include <functional>
#include <map>
#include <optional>

namespace campanel::panel {

class Editor : public QObject, public Singleton<Editor> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    Q_PROPERTY(campanel::panel::CutterParts cutter READ cutter CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::EditorPlot plot READ plot NOTIFY solutionChanged FINAL)
    Q_PROPERTY(campanel::panel::ProgramDownload* programDownload READ programDownload CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::EditorField* lawParameter1 READ lawParameter1 CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::EditorField* lawParameter2 READ lawParameter2 CONSTANT FINAL)

    // The kind of program, its relevant fields, and the machine data that it needs.
    Q_PROPERTY(Kind kind READ kind NOTIFY kindChanged FINAL)
    Q_PROPERTY(QVariantList kinds READ kinds NOTIFY kindChanged FINAL) // shapedName, in the order of Kind
    Q_PROPERTY(QVariantList fields READ fields NOTIFY fieldsChanged FINAL)
    Q_PROPERTY(QVariantList machineFields READ machineFields NOTIFY fieldsChanged FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* choices READ choices CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::CamLists cam READ cam CONSTANT FINAL)
    // The handles on the curve; null for a kind without any.
    Q_PROPERTY(campanel::panel::CamHandles* handles READ handles NOTIFY kindChanged FINAL)
    // Empty for a kind without a law.
    Q_PROPERTY(QString lawTitle READ lawTitle NOTIFY kindChanged FINAL)

    Q_PROPERTY(campanel::panel::RowModelBase* laws READ laws CONSTANT FINAL)
    Q_PROPERTY(QString lawName READ lawName NOTIFY solutionChanged FINAL)
    Q_PROPERTY(QStringList lawColumns READ lawColumns NOTIFY solutionChanged FINAL)

    Q_PROPERTY(bool solvable READ solvable NOTIFY solutionChanged FINAL)
    Q_PROPERTY(QString verdict READ verdict NOTIFY solutionChanged FINAL)
    Q_PROPERTY(Severity severity READ severity NOTIFY solutionChanged FINAL)
    Q_PROPERTY(QString suggestionText READ suggestionText NOTIFY solutionChanged FINAL)
    Q_PROPERTY(int suggestionLevel READ suggestionLevel NOTIFY solutionChanged FINAL)

    Q_PROPERTY(QVariant overlayCurves READ overlayCurves NOTIFY overlayChanged FINAL)
    Q_PROPERTY(QString overlayName READ overlayName NOTIFY overlayChanged FINAL)

    Q_PROPERTY(campanel::panel::TableModel* table READ table CONSTANT FINAL)

    // The level that undo and redo need; -1: there is nothing to undo or redo.
    Q_PROPERTY(int undoLevel READ undoLevel NOTIFY historyChanged FINAL)
    Q_PROPERTY(int redoLevel READ redoLevel NOTIFY historyChanged FINAL)
    Q_PROPERTY(QString recipeName READ recipeName WRITE setRecipeName NOTIFY recipeChanged FINAL)
    Q_PROPERTY(int recipeVersion READ recipeVersion NOTIFY recipeChanged FINAL)
    Q_PROPERTY(bool edited READ edited NOTIFY recipeChanged FINAL)
    Q_PROPERTY(QString notice READ notice NOTIFY noticeChanged FINAL)

public:
    enum class Kind {
        RotaryCutter = static_cast<int>(profile::ProgramKind::RotaryCutter),
        PositionMove = static_cast<int>(profile::ProgramKind::PositionMove),
        SpeedMove = static_cast<int>(profile::ProgramKind::SpeedMove),
        PointCam = static_cast<int>(profile::ProgramKind::PointCam),
        Press = static_cast<int>(profile::ProgramKind::Press),
        SegmentCam = static_cast<int>(profile::ProgramKind::SegmentCam),
    };
    Q_ENUM(Kind)
    enum class Severity { Good, Warning, Bad };
    Q_ENUM(Severity)

    // Stores both recipes in `folder`. A default recipe never takes the place of edits that cannot be read.
    // The controller must outlive the object.
    Editor(Controller& controller, const QString& folder, QObject* parent);
    ~Editor() override;

    [[nodiscard]] EditorField* bagLength() { return item(profile::Field::BagLength); }
    [[nodiscard]] EditorField* rate() { return item(profile::Field::Rate); }
    [[nodiscard]] EditorField* baseSpeed() { return item(profile::Field::BaseSpeed); }
    [[nodiscard]] EditorField* filmSpeed() { return item(profile::Field::FilmSpeed); }
    [[nodiscard]] EditorField* k1() { return item(profile::Field::K1); }
    [[nodiscard]] EditorField* k2() { return item(profile::Field::K2); }
    [[nodiscard]] EditorField* k3() { return item(profile::Field::K3); }
    [[nodiscard]] EditorField* rampSlices() { return item(profile::Field::SlicesPerRamp); }
    [[nodiscard]] EditorField* minSealTime() { return item(profile::Field::MinSealTime); }
    [[nodiscard]] CutterParts cutter();
    [[nodiscard]] EditorPlot plot() const;
    [[nodiscard]] ProgramDownload* programDownload() { return &m_download; }
    [[nodiscard]] EditorField* lawParameter1() { return &m_lawParameter1; }
    [[nodiscard]] EditorField* lawParameter2() { return &m_lawParameter2; }

    // Returns the field with that name in recipe files, for QML.
    [[nodiscard]] Q_INVOKABLE campanel::panel::EditorField* field(const QString& name);
    [[nodiscard]] EditorField* item(profile::Field field)
    {
        return m_fields[static_cast<std::size_t>(field)];
    }
    [[nodiscard]] Kind kind() const { return static_cast<Kind>(m_recipe.kind()); }
    [[nodiscard]] QVariantList kinds() const;
    [[nodiscard]] QVariantList fields() const; // list of EditorField*
    [[nodiscard]] QVariantList machineFields() const;
    [[nodiscard]] ChoiceModel* choices() { return &m_choices; }
    [[nodiscard]] CamLists cam() { return {&m_knots, &m_camFiles, &m_segments}; }
    [[nodiscard]] KnotModel* knots() { return &m_knots; }
    [[nodiscard]] CutterMap* map() { return &m_map; }
    [[nodiscard]] SegmentModel* segments() { return &m_segments; }
    [[nodiscard]] CamHandles* handles();
    [[nodiscard]] CamFiles* camFiles() { return &m_camFiles; }
    [[nodiscard]] RampControl* ramps() { return &m_ramps; }
    [[nodiscard]] bool hasLaw() const { return program::lawParameters(m_recipe.program) != nullptr; }
    [[nodiscard]] QString lawTitle() const;
    [[nodiscard]] QStringList lawColumns() const;
    [[nodiscard]] LawModel* laws() { return &m_laws; }
    [[nodiscard]] QString lawName() const;
    [[nodiscard]] bool solvable() const { return m_solution.solved.has_value(); }
    [[nodiscard]] bool feasible() const { return m_solution.isFeasible(); }
    [[nodiscard]] QString verdict() const;
    [[nodiscard]] Severity severity() const;
    [[nodiscard]] QString suggestionText() const;
    [[nodiscard]] int suggestionLevel() const;
    [[nodiscard]] QVariant overlayCurves() const;
    [[nodiscard]] QString overlayName() const;
    [[nodiscard]] QString peakText() const;
    [[nodiscard]] TableModel* table() { return &m_table; }
    [[nodiscard]] bool canUndo() const { return m_history.canUndo(); }
    [[nodiscard]] bool canRedo() const { return m_history.canRedo(); }
    [[nodiscard]] int undoLevel() const;
    [[nodiscard]] int redoLevel() const;
    [[nodiscard]] QString recipeName() const { return QString::fromStdString(m_recipe.name); }
    void setRecipeName(const QString& name);
    // Returns the newest saved version of the open recipe; 0: none.
    [[nodiscard]] int recipeVersion() const;
    // Returns true when there is something to save: edits, or a recipe that was never saved.
    [[nodiscard]] bool edited() const;
    [[nodiscard]] QString notice() const { return m_notice; }

    // Creates a recipe of this kind with the defaults of its paper. Can be undone.
    Q_INVOKABLE void newProgram(int kind);
    Q_INVOKABLE void setChoice(int row, int option);
    Q_INVOKABLE void setLaw(const QString& lawId);
    // Fills laws() while they are displayed: each law is a program of its own to be solved.
    Q_INVOKABLE void watchLaws(bool isWatched);
    // Displays the curves of the same motion with another law in the background; an empty id ends it.
    Q_INVOKABLE void compareLaw(const QString& lawId);
    Q_INVOKABLE void applySuggestion();
    // Moves the end of segment `index` (0..3: ta, tb, tc, td) during a drag; commitDrag() ends it as one undo
    // step.
    Q_INVOKABLE void dragRatio(int index, double timeSeconds);
    Q_INVOKABLE void commitDrag();
    Q_INVOKABLE void undo();
    Q_INVOKABLE void redo();
    Q_INVOKABLE void revert();
    // Edits that are tried on Run: unless they are kept, the end brings back what was there at the begin.
    Q_INVOKABLE void beginTrial();
    Q_INVOKABLE void endTrial(bool isKept);
    // Confirms the net advance of the cam; only that makes a progressive one downloadable.
    Q_INVOKABLE void confirmAdvance();
    // Ends the cam where it began. Can be undone.
    Q_INVOKABLE void closeCam();
    Q_INVOKABLE void download();
    Q_INVOKABLE void cancelDownload();
    Q_INVOKABLE void saveToFlash();
    Q_INVOKABLE void dismissNotice();

    // Returns the results computed from the present recipe.
    [[nodiscard]] const Solution& solution() const { return m_solution; }
    [[nodiscard]] const program::Recipe& recipe() const { return m_recipe; }
    // Returns the reference of edited(): the version last opened, downloaded or saved.
    [[nodiscard]] const program::Recipe& storedRecipe() const { return m_stored; }

    // Where the recipe and its edits at the start came from; Saved once another recipe was opened.
    struct Sources {
        store::LastRecipe::Source stored = store::LastRecipe::Source::Saved;
        store::LastRecipe::Source working = store::LastRecipe::Source::Saved;
    };
    [[nodiscard]] const Sources& sources() const { return m_sources; }
    // Shows a sentence until a person dismisses it.
    void showNotice(const QString& text);

    // Opens another recipe, unchanged or with the edits in `edited`. Clears the previous recipe and the undo
    // history.
    void open(const program::Recipe& stored, const std::optional<program::Recipe>& edited = {});
    // Sets the saved recipe as the new reference of edited(); the edits stay. Calls `done` once its file is
    // written, or cannot be.
    void takeStored(
        const program::Recipe& recipe, std::function<void()> done = [] {});
    // Returns the newest stored version of a name, 0: none. An edited recipe has the next version.
    using NewestVersion = std::function<int(const std::string& name)>;
    void setNewestVersion(NewestVersion newest);
    void setMachine(profile::ProgramKind kind, const profile::Machine& machine)
    {
        m_machines[kind] = machine;
    }
    // Returns a recipe with the defaults of its kind, for this machine and its master.
    [[nodiscard]] program::Recipe newRecipe(profile::ProgramKind kind) const;

signals:
    // Emitted when the controller executes the recipe, and its file is written or cannot be.
    void applied(const campanel::program::Recipe& recipe);
    void kindChanged();
    void fieldsChanged();
    void overlayChanged();
    void solutionChanged();
    void historyChanged();
    void recipeChanged();
    void noticeChanged();
    // Emitted for the audit trail, see ProgramDownload.
    void downloadBegun(const campanel::program::ProgramImage& image);
    void downloadEnded(const campanel::link::DownloadReport& report);

private:
    void connectFields();
    void connectKnots();
    void connectMap();
    void connectRamps();
    // Shows a step of a drag; commitDrag() ends it as one undo step.
    template <typename Change> void drag(Level needed, Change change);
    // Sets the ratios that were not set by hand.
    void follow(program::Recipe& recipe) const;
    void connectHandles(CamHandles& handles);
    void compareCurves();
    void shareMachine();
    void showFields();
    // Returns true when the person has the level. Otherwise requests a login, and nothing changes.
    [[nodiscard]] bool require(Level needed) const;
    template <typename Change> void edit(Level needed, Change change);
    void replace(program::Recipe recipe); // undo, redo, revert
    void recompute();
    void takeSolution(Solution solution);
    void show();
    void watchController();
    // Returns the maximum speed of the master as a share of the rate, where an encoder leads this recipe.
    [[nodiscard]] std::optional<double> maxMasterSpeedShare() const;
    void keepWorkingCopy();
    void loadWorkingCopy();
    void write(const store::LastRecipe& file, const program::Recipe& recipe, std::function<void()> done);
    [[nodiscard]] const profile::Suggestion* suggestion() const;
    [[nodiscard]] int nextVersion() const;

    EditorField m_lawParameter1{QStringLiteral("lawParameter1"), this};
    EditorField m_lawParameter2{QStringLiteral("lawParameter2"), this};
    std::array<EditorField*, profile::fields.size()> m_fields{}; // children, by field
    KnotModel m_knots;
    SegmentModel m_segments;
    CamFiles m_camFiles;
    CutterMap m_map;
    RampControl m_ramps;
    ChoiceModel m_choices;
    LawModel m_laws;
    TableModel m_table;

    Controller& m_controller;
    ProgramDownload m_download;
    store::LastRecipe m_storedFile;
    store::LastRecipe m_workingFile;
    QThreadPool m_writer; // one thread; the destructor waits for it
    QTimer m_keepTimer;
    QTimer m_tableTimer;      // builds a slow table once the finger rests
    program::Recipe m_stored; // version 0: nothing was saved yet
    program::Recipe m_recipe;
    bool m_isNameProposed = false; // nobody typed the name of the first recipe: it follows the length
    Sources m_sources;
    NewestVersion m_newestVersion = [](const std::string&) { return 0; };
    std::map<profile::ProgramKind, profile::Machine> m_machines;
    std::optional<program::Recipe> m_beforeDrag;
    EditHistory<program::Recipe> m_history;
    struct Trial {
        program::Recipe recipe;
        EditHistory<program::Recipe> history;
    };
    std::optional<Trial> m_trial;
    std::optional<modbus::Identity> m_identity; // controller that the solution was computed for
    Solution m_solution;
    program::Recipe m_solvedFor;
    std::optional<profile::LawId> m_comparedLaw;
    bool m_areLawsWatched = false;
    std::shared_ptr<const profile::Curves> m_comparedCurves;
    QList<profile::Field> m_shownFields; // last fields reported by fieldsChanged()
    double m_cycleSeconds = 1;           // the last known one, so that the handles keep their places
    QString m_notice;
};

} // namespace campanel::panel
