// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Signature and digest, bit after bit. [SRS_CFG_010, SRS_CFG_034]
#include "verification/twins/plain/point.hpp"
#include "verification/twins/plain/record.hpp"

namespace counterpoint::twins::plain
{

namespace
{
const Number kPolynomial{"SRS_CFG_010", "polynomial of the signature"};
const Number kStart{"SRS_CFG_010", "start value of the signature"};
const Number kFinal{"SRS_CFG_010", "final XOR of the signature"};
const Act kEnters{"SRS_CFG_010", "a byte enters the register"};
const Decision kDivides{"SRS_CFG_010", "a bit that leaves takes the polynomial away"};
const Act kSubIndices{"SRS_CFG_010", "the sub-index of an entry counts"};
const Number kSubIndex{"SRS_CFG_010", "the sub-index of an entry"};
const Act kEntries{"SRS_CFG_010", "the value of an entry counts"};
const Number kEntry{"SRS_CFG_010", "the value of an entry"};
const Act kNoReflection{"SRS_CFG_010", "most significant bit first"};
const Number kFirstEntry{"SRS_CFG_010", "the first entry"};
const Number kLastEntry{"SRS_CFG_010", "the last entry"};
const Each kEachEntry{"SRS_CFG_010", "entries that count"};
const Number kCountOfEntries{"SRS_CFG_020", "entries that exist"};
const Act kCuts{"SRS_CFG_020", "a map count above map_entries counts as that"};
const Act kCutsCount{"SRS_CFG_020", "the byte of the map count is cut"};
const Number kDirection{"SRS_CFG_010", "direction"};
const Number kSct{"SRS_CFG_010", "refresh time or SCT"};
const Number kSrvt{"SRS_CFG_010", "SRVT"};
const Number kCobId1{"SRS_CFG_010", "COB-ID 1"};
const Number kCobId2{"SRS_CFG_010", "COB-ID 2"};
const Number kCount{"SRS_CFG_010", "map count"};
const Act kHasDirection{"SRS_CFG_010", "direction counts"};
const Act kHasSct{"SRS_CFG_010", "refresh time or SCT counts"};
const Act kHasSrvt{"SRS_CFG_010", "SRVT counts"};
const Act kHasCobId1{"SRS_CFG_010", "COB-ID 1 counts"};
const Act kHasCobId2{"SRS_CFG_010", "COB-ID 2 counts"};
const Act kHasCount{"SRS_CFG_010", "map count counts"};
const Act kLowByteFirst{"SRS_CFG_010", "the low byte first"};
const Act kGoesOn{"SRS_CFG_010", "what came before stays"};

const Number kDigestPolynomial{"SRS_CFG_034", "polynomial of the digest"};
const Number kDigestStart{"SRS_CFG_034", "start value of the digest"};
const Number kDigestFinal{"SRS_CFG_034", "final complement of the digest"};
const Act kDigestReflected{"SRS_CFG_034", "the digest is reflected"};
const Act kDigestContinues{"SRS_CFG_034", "the digest continues"};
const Decision kDigestFirst{"SRS_CFG_034", "slot 0 has the device first"};
const Act kDigestLowByteFirst{"SRS_CFG_034", "the low byte first"};
const Act kDigestEnters{"SRS_CFG_034", "a byte enters the register"};
const Decision kDigestDivides{"SRS_CFG_034", "a bit that leaves takes the polynomial away"};

const Act kDigestWords{"SRS_CFG_034", "values of four bytes count"};
const Number kDigestWord{"SRS_CFG_034", "a value of four bytes"};
const Number kDigestWordBytes{"SRS_CFG_034", "bytes of a value of four bytes"};
const Sum kSubSum{"SRS_CFG_010", "place of an entry and 1"};

class Crc16
{
  public:
    Crc16() noexcept : value_{kStart(std::uint16_t{0U})}
    {
    }
    void Add(std::uint32_t value, std::uint32_t bytes) noexcept
    {
        value_ = kGoesOn() ? value_ : std::uint16_t{0U};
        for (std::uint32_t i = 0U; i < bytes; ++i)
        {
            const std::uint32_t at = kLowByteFirst() ? i : (bytes - 1U - i);
            Take((value >> (8U * at)) & 0xFFU);
        }
    }
    [[nodiscard]] std::uint16_t Value() const noexcept
    {
        return static_cast<std::uint16_t>(value_ ^ kFinal(std::uint16_t{0U}));
    }

  private:
    void Take(std::uint32_t byte) noexcept
    {
        for (std::uint32_t bit = 0U; bit < 8U; ++bit)
        {
            const std::uint32_t at = kNoReflection() ? (7U - bit) : bit;
            const std::uint32_t in = kEnters() ? ((byte >> at) & 1U) : 0U;
            const bool leaves = kDivides((((static_cast<std::uint32_t>(value_) >> 15U) ^ in) & 1U) != 0U);
            value_ = static_cast<std::uint16_t>((static_cast<std::uint32_t>(value_) << 1U) ^
                                                (leaves ? kPolynomial(0x1021U) : 0U));
        }
    }

    std::uint16_t value_;
};

class Crc32
{
  public:
    explicit Crc32(std::uint32_t before) noexcept : value_{kDigestContinues() ? (before ^ Start()) : Start()}
    {
    }
    void Add(std::uint32_t given, std::uint32_t whole) noexcept
    {
        const bool is_word = whole == 4U;
        const std::uint32_t value = is_word ? kDigestWord(given) : given;
        const std::uint32_t bytes = is_word ? (kDigestWords() ? kDigestWordBytes(whole) : 0U) : whole;
        for (std::uint32_t i = 0U; (i < bytes) && (i <= 8U); ++i)
        {
            const std::uint32_t place = kDigestLowByteFirst() ? i : (bytes - 1U - i);
            const std::uint32_t byte = (place < 4U) ? ((value >> (8U * place)) & 0xFFU) : 0U;
            for (std::uint32_t bit = 0U; bit < 8U; ++bit)
            {
                const std::uint32_t at = kDigestReflected() ? bit : (7U - bit);
                const std::uint32_t in = kDigestEnters() ? ((byte >> at) & 1U) : 0U;
                const bool leaves = kDigestDivides(((value_ ^ in) & 1U) != 0U);
                value_ = (value_ >> 1U) ^ (leaves ? kDigestPolynomial(0xEDB88320U) : 0U);
            }
        }
    }
    [[nodiscard]] std::uint32_t Value() const noexcept
    {
        return value_ ^ kDigestFinal(0xFFFFFFFFU);
    }

  private:
    static std::uint32_t Start() noexcept
    {
        return kDigestStart(0xFFFFFFFFU);
    }

    std::uint32_t value_;
};

template <typename T> std::uint32_t OnlyIf(T value, T counts) noexcept
{
    return (value == counts) ? static_cast<std::uint32_t>(counts) : 0U;
}

void AddDevice(Crc32& crc, const Common& common) noexcept
{
    const DeviceConfig& config = common.config;
    crc.Add(config.node_id, 1U);
    crc.Add(config.granularity_bits, 1U);
    crc.Add(OnlyIf(config.dummies, DummyMapping::kAllowed), 1U);
    crc.Add(OnlyIf(config.gaps, NumberGaps::kSearched), 1U);
    crc.Add(OnlyIf(config.gfc, GfcUse::kPresent), 1U);
    crc.Add(static_cast<std::uint32_t>(config.normal_port), 1U);
    crc.Add(static_cast<std::uint32_t>(config.inverse_port), 1U);
    for (const std::uint32_t time :
         {config.cycle_us, config.cycle_tolerance_us, config.discrepancy_us, config.acknowledge_window_us,
          config.diagnostic_interval_us, config.test_interval_us, config.clock_tolerance_us, config.clock_interval_us,
          config.output_time_us})
    {
        crc.Add(time, 4U);
    }
    crc.Add(common.gfc_parameter, 1U);
}

} // namespace

std::uint16_t SignatureOf(const Common& common, const Record& record) noexcept
{
    const Stored& stored = record.stored;
    const std::uint32_t whole = CountOf(record);
    const std::uint32_t count = kCountOfEntries(kCuts() ? ExistingOf(common, record) : whole);
    Crc16 crc;
    crc.Add(kDirection(stored.direction), kHasDirection() ? 1U : 0U);
    crc.Add(kSct(stored.sct_ms), kHasSct() ? 2U : 0U);
    crc.Add(kSrvt(stored.srvt_ms), kHasSrvt() ? 1U : 0U);
    crc.Add(kCobId1(stored.cob_id_1), kHasCobId1() ? 4U : 0U);
    crc.Add(kCobId2(stored.cob_id_2), kHasCobId2() ? 4U : 0U);
    crc.Add(kCount(kCutsCount() ? count : whole), kHasCount() ? 1U : 0U);
    for (std::uint32_t number = kFirstEntry(1U); number <= kLastEntry(count); ++number)
    {
        if (number > 256U)
        {
            break;
        }
        if (!kEachEntry(number - 1U))
        {
            continue;
        }
        crc.Add(kSubIndex(kSubSum(number - 1U, 1U)), kSubIndices() ? 1U : 0U);
        crc.Add(kEntry(EntryOf(record, number)), kEntries() ? 4U : 0U);
    }
    return crc.Value();
}

std::uint32_t DigestOf(const Common& common, const Record& record, bool is_first, std::uint32_t before) noexcept
{
    Crc32 crc{before};
    if (kDigestFirst(is_first))
    {
        AddDevice(crc, common);
    }
    crc.Add(record.setup.number, 1U);
    crc.Add(OnlyIf(record.setup.policy, ReleasePolicy::kAutomatic), 1U);
    crc.Add(OnlyIf(record.setup.form, ProducerForm::kProviderCalled), 1U);
    crc.Add(OnlyIf(record.setup.detection, SrvtDetection::kLate), 1U);
    crc.Add(record.stored.transmission_type, 1U);
    crc.Add(record.setup.safe_value.low, 4U);
    crc.Add(record.setup.safe_value.high, 4U);
    return crc.Value();
}

} // namespace counterpoint::twins::plain
