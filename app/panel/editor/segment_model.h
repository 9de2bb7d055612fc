// SPDX-License-Identifier: Apache-2.0
// The segments of a cam as a list, and their ends as handles on the curve.
#pragma once

#include "app/panel/editor/cam_handles.h"
#include "app/panel/editor/editor_field.h"
#include "app/panel/kit/row_model.h"
#include "profile/segments/segment_edit.h"

#include <QStringList>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <vector>

namespace campanel::panel {

struct SegmentRow {
    Q_GADGET
    Q_PROPERTY(int number MEMBER number)
    Q_PROPERTY(QString rangeText MEMBER rangeText)
    Q_PROPERTY(QString motionText MEMBER motionText)
    Q_PROPERTY(bool jumps MEMBER jumps)
    Q_PROPERTY(bool selected MEMBER isSelected)

public:
    int number = 0; // from 1
    QString rangeText;
    QString motionText;
    bool jumps = false; // at its beginning
    bool isSelected = false;

    bool operator==(const SegmentRow&) const = default;
};

using SegmentRows = RowModel<SegmentRow, &SegmentRow::number>;

class SegmentModel : public campanel::panel::CamHandles {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Segments belong to the Editor")
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ rows CONSTANT FINAL)
    // The numbers that the selected segment has; list of EditorField*.
    Q_PROPERTY(QVariantList fields READ fields NOTIFY fieldsChanged FINAL)
    // The names of the motions that a segment may have, and the selected segment's one.
    Q_PROPERTY(QVariantList motions READ motions NOTIFY changed FINAL) // shapedName
    Q_PROPERTY(int motion READ motion NOTIFY changed FINAL)
    Q_PROPERTY(QString motionName READ motionName NOTIFY changed FINAL)
    Q_PROPERTY(QString jointText READ jointText NOTIFY changed FINAL)
    Q_PROPERTY(bool canRepair READ canRepair NOTIFY changed FINAL)
    Q_PROPERTY(bool canDivide READ canDivide NOTIFY changed FINAL)
    Q_PROPERTY(bool canRemove READ canRemove NOTIFY changed FINAL)

public:
    explicit SegmentModel(QObject* parent);

    [[nodiscard]] SegmentRows* rows() { return &m_rows; }
    [[nodiscard]] QVariantList fields() const;
    // Returns the field with this id, such as "segmentTo"; null when the selected segment does not have it.
    [[nodiscard]] EditorField* field(const QString& fieldId) const;
    [[nodiscard]] QVariantList motions() const;
    [[nodiscard]] int motion() const;
    [[nodiscard]] QString motionName() const;
    [[nodiscard]] QString jointText() const;
    [[nodiscard]] bool canRepair() const;
    [[nodiscard]] bool canDivide() const;
    [[nodiscard]] bool canRemove() const;

    Q_INVOKABLE void setMotion(int index);
    // Inserts a dwell in the second half of the selected segment and selects it.
    Q_INVOKABLE void addDwell();
    // Divides the selected segment at its middle and selects the second part.
    Q_INVOKABLE void split();
    Q_INVOKABLE void removeSelected();
    // Closes gaps and overlaps, and takes every jump out of the joints.
    Q_INVOKABLE void repair();

signals:
    void fieldsChanged();

protected:
    [[nodiscard]] int listSize(const profile::Program& program) const override;
    [[nodiscard]] bool isValid(const profile::Program& program) const override;
    [[nodiscard]] double masterDegOf(const profile::Program& program, int index) const override;
    [[nodiscard]] double startDegOf(const profile::Program& program, int index) const override;
    void moveBy(profile::Program& program, int index, double deg, double mm) const override;
    void showSelection() override;

private:
    [[nodiscard]] const profile::SegmentCamProgram& cam() const
    {
        return std::get<profile::SegmentCamProgram>(*program());
    }
    [[nodiscard]] const profile::CamSegment& at(int index) const
    {
        return cam().segments[static_cast<std::size_t>(index)];
    }
    void enter(std::size_t field, double value);
    void showRows();
    void showFields();

    SegmentRows m_rows{this};
    std::vector<EditorField*> m_fields; // children, in the order of numbers
    std::vector<std::size_t> m_shown;   // of m_fields
};

} // namespace campanel::panel
