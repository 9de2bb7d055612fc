// SPDX-License-Identifier: Apache-2.0
#include "profile/segments/segments_csv.h"

#include "profile/laws/laws.h"
#include "profile/segments/segment_values.h"

namespace campanel::profile {
namespace {

constexpr std::size_t placeColumns = 3; // from, to, motion

tl::expected<CamSegment, CsvError> segmentOf(detail::CsvReader& reader,
                                             std::span<const std::string_view> fields)
{
    CamSegment segment;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto number = reader.number(fields[i]);
        if (!number)
            return tl::unexpected(number.error());
        (i == 0 ? segment.fromDeg : segment.toDeg) = *number;
    }
    const SegmentMotionInfo* motion = findSegmentMotion(fields[2]);
    if (motion == nullptr)
        return reader.fail(CsvExpectation::Motion, fields[2]);
    segment.motion = motion->motion;
    if (motion->law != nullptr)
        segment.lawParameters = defaultParameters(*motion->law);
    for (std::size_t i = 0; i < segmentEndValues.size(); ++i) {
        const std::string_view field = fields[placeColumns + i];
        // The parameters of a law have their defaults; what else a motion uses must be there.
        const bool mayBeMissing =
            !segmentEndValues[i].isUsed(*motion) || segmentEndValues[i].id.starts_with("law_");
        if (field.empty() && mayBeMissing)
            continue;
        const auto number = reader.number(field);
        if (!number)
            return tl::unexpected(number.error());
        if (segmentEndValues[i].isUsed(*motion))
            segmentEndValues[i].number(segment) = *number;
    }
    return segment;
}

} // namespace

std::span<const std::string_view> segmentColumns()
{
    static const std::vector<std::string_view> columns = [] {
        std::vector<std::string_view> names{"from_deg", "to_deg", "motion"};
        for (const SegmentValueInfo& value : segmentEndValues)
            names.push_back(value.id);
        return names;
    }();
    return columns;
}

tl::expected<std::vector<CamSegment>, CsvError> readSegmentsCsv(std::string_view text)
{
    detail::CsvReader reader(text);
    if (const auto header = reader.readHeader(segmentColumns(), placeColumns); !header)
        return tl::unexpected(header.error());
    std::vector<CamSegment> segments;
    for (;;) {
        const auto row = reader.readRow();
        if (!row)
            return tl::unexpected(row.error());
        if (!*row)
            break;
        const auto segment = segmentOf(reader, **row);
        if (!segment)
            return tl::unexpected(segment.error());
        segments.push_back(*segment);
        if (segment->motion == SegmentMotion::Dwell)
            segments.back().endMm = jointPositionsMm(segments).back();
    }
    if (segments.empty())
        return reader.fail(CsvExpectation::Rows, {});
    return segments;
}

std::string writeSegmentsCsv(std::span<const CamSegment> segments, const CsvDialect& dialect)
{
    CsvWriter csv(dialect);
    for (const std::string_view column : segmentColumns())
        csv.add(column);
    csv.endLine();
    for (CamSegment segment : segments) {
        const SegmentMotionInfo* motion = findSegmentMotion(segment.motion);
        csv.addNumber(segment.fromDeg);
        csv.addNumber(segment.toDeg);
        csv.add(motion->key);
        for (const SegmentValueInfo& value : segmentEndValues) {
            if (value.isUsed(*motion))
                csv.addNumber(value.number(segment));
            else
                csv.add({});
        }
        csv.endLine();
    }
    return csv.text();
}

} // namespace campanel::profile
