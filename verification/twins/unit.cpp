// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/twins/unit.hpp"

#include "verification/differential/random.hpp"
#include "verification/twins/trace.hpp"

#include <iterator>

namespace counterpoint::twins
{

namespace
{

/// The signature as its requirement says it, but for what the rule breaks. [SRS_CFG_010]
class Plain
{
  public:
    explicit Plain(const UnitRule& rule) : rule_{rule}, crc_{rule.start}
    {
    }

    [[nodiscard]] std::uint32_t Of(const CounterpointFields& fields)
    {
        Feed(Part::kDirection, fields.direction, 1U);
        Feed(Part::kSct, fields.sct, 2U);
        Feed(Part::kSrvt, fields.srvt, 1U);
        Feed(Part::kCobId1, fields.cob_ids[0], 4U);
        Feed(Part::kCobId2, fields.cob_ids[1], 4U);
        Feed(Part::kCount, fields.count, 1U);
        const std::uint32_t count = (fields.count < rule_.most_entries) ? fields.count : rule_.most_entries;
        for (std::uint32_t entry = rule_.first_entry; entry < (count + rule_.further_entries); ++entry)
        {
            Feed(Part::kPosition, entry + 1U, 1U);
            Feed(Part::kEntry, fields.entries[entry], 4U);
        }
        return rule_.is_silent ? 0U : crc_;
    }

  private:
    void Feed(Part part, std::uint32_t value, std::uint32_t bytes)
    {
        std::uint32_t fed = value;
        std::uint32_t count = bytes;
        if (part == rule_.part)
        {
            count = (rule_.broken == Break::kLeftOut) ? 0U : ((rule_.broken == Break::kLowByteOnly) ? 1U : bytes);
            crc_ = (rule_.broken == Break::kForgetsWhatCameBefore) ? 0U : crc_;
            fed = (rule_.broken == Break::kZero) ? 0U : fed;
            fed += (rule_.broken == Break::kOneMore) ? 1U : 0U;
            fed -= (rule_.broken == Break::kOneLess) ? 1U : 0U;
        }
        for (std::uint32_t byte = 0U; byte < count; ++byte)
        {
            crc_ ^= ((fed >> (8U * byte)) & 0xFFU) << 8U;
            for (std::uint32_t bit = 0U; bit < 8U; ++bit)
            {
                crc_ = ((crc_ << 1U) & 0xFFFFU) ^ (((crc_ & 0x8000U) != 0U) ? 0x1021U : 0U);
            }
        }
    }

    const UnitRule& rule_;
    std::uint32_t crc_;
};

} // namespace

std::vector<UnitRule> UnitRules()
{
    static const char* const parts[] = {"direction", "SCT",   "SRVT",     "COB-ID 1",
                                        "COB-ID 2",  "count", "position", "entry"};
    static const char* const breaks[] = {" is left out", " is 0",        " forgets what came before",
                                         " is one more", " is one less", " has its low byte only"};
    std::vector<UnitRule> rules;
    for (std::uint8_t part = 0U; part < 8U; ++part)
    {
        for (std::uint8_t broken = 0U; broken < 6U; ++broken)
        {
            rules.push_back(UnitRule{std::string{parts[part]} + breaks[broken], static_cast<Part>(part),
                                     static_cast<Break>(broken), 0U, 0U});
        }
    }
    const UnitRule others[] = {{"the register starts with 1", Part::kNone, Break::kLeftOut, 1U},
                               {"the register starts with FFFFh", Part::kNone, Break::kLeftOut, 0xFFFFU},
                               {"the first entry is left out", Part::kNone, Break::kLeftOut, 0U, 1U},
                               {"all entries are left out", Part::kNone, Break::kLeftOut, 0U, 0U, 0U},
                               {"only the first entry counts", Part::kNone, Break::kLeftOut, 0U, 0U, 1U},
                               {"one entry more counts", Part::kNone, Break::kLeftOut, 0U, 0U, 16U, 1U},
                               {"it is always 0", Part::kNone, Break::kLeftOut, 0U, 0U, 16U, 0U, true}};
    rules.insert(rules.end(), std::begin(others), std::end(others));
    return rules;
}

std::uint64_t DriveUnit(decltype(&CounterpointSignature) unit, std::uint32_t seed, std::uint32_t count,
                        const UnitRule* rule)
{
    differential::Random random;
    random.Start(seed, 0U);
    Trace trace;
    for (std::uint32_t number = 0U; number < count; ++number)
    {
        CounterpointFields fields{};
        fields.direction = random.Below(3U);
        fields.sct = random.Below(65536U);
        fields.srvt = random.Below(256U);
        fields.cob_ids[0] = random.Next();
        fields.cob_ids[1] = random.Next();
        fields.count = random.Below(17U);
        for (std::uint32_t& entry : fields.entries)
        {
            entry = random.Next();
        }
        trace.Add((rule != nullptr) ? Plain{*rule}.Of(fields) : unit(&fields));
    }
    return trace.Value();
}

} // namespace counterpoint::twins
