// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/generate/random_device.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/safety/signing.hpp"

#include <set>
#include <vector>

namespace counterpoint::generate::test
{
namespace
{
/// One pair of a mapping.
struct Pair
{
    std::uint32_t bits{0U};
    bool is_dummy{false};
    std::uint64_t value{0U};
};

struct Srdo
{
    std::uint32_t number{0U};
    std::uint32_t direction{0U};
    bool is_static{false};
    std::uint64_t safe_value{0U};
    std::vector<Pair> pairs;
};

std::uint32_t TypeOf(Random& random, const std::uint32_t bits)
{
    switch (bits)
    {
    case 1U:
        return random.OneIn(2U) ? 0x01U : 0x30U;
    case 8U:
        return random.OneIn(2U) ? 0x05U : 0x02U;
    case 16U:
        return random.OneIn(2U) ? 0x06U : 0x03U;
    case 24U:
        return random.OneIn(2U) ? 0x16U : 0x10U;
    case 32U:
        return random.OneIn(3U) ? 0x08U : 0x07U;
    case 40U:
        return 0x18U;
    case 48U:
        return random.OneIn(2U) ? 0x19U : 0x0CU;
    case 56U:
        return 0x1AU;
    case 64U:
        return random.OneIn(3U) ? 0x11U : 0x1BU;
    default:
        return 0x2FU + bits; // BIT2 to BIT7.
    }
}

/// Writes one random device.
class Writer
{
  public:
    explicit Writer(const std::uint64_t seed) : random_(seed * 4096U + seed), kind_(seed % 4U)
    {
        has_bits_ = kind_ == 0U || kind_ == 3U;
    }

    std::string Text()
    {
        Choose();
        text_ = "[FileInfo]\nFileName=random.dcf\n\n[DeviceInfo]\nCANopenSafetySupported=1\n\n"
                "[DeviceComissioning]\nNodeID=" +
                std::to_string(1U + random_.Below(127U)) + "\n\n[DummyUsage]\nDummy0005=1\nDummy0006=1\n\n";
        text_ += Section("1000", "Device type", 7U, "ro", "0x00000191");
        text_ += Section("1001", "Error register", 5U, "ro", "0");
        text_ += Section("1008", "Manufacturer device name", 9U, "const", "Random device");
        text_ += Section("1014", "COB-ID EMCY", 7U, "rw", "$NODEID+0x80");
        text_ += Section("1017", "Producer heartbeat time", 6U, "rw", "100");
        text_ += Section("1300", "GFC parameter", 5U, "rw", "1");
        for (const Srdo& srdo : srdos_)
        {
            AppendCommunication(srdo);
            AppendMapping(srdo);
            AppendVariables(srdo);
        }
        AppendSignatures();
        AppendParameters();
        return text_ + RandomObjects(random_);
    }

  private:
    void Choose()
    {
        const std::uint32_t count = kind_ == 1U ? 8U + random_.Below(57U) : 1U + random_.Below(4U);
        std::set<std::uint32_t> numbers;
        while (numbers.size() < count)
        {
            numbers.insert(1U + random_.Below(64U));
        }
        for (const std::uint32_t number : numbers)
        {
            Srdo srdo;
            srdo.number = number;
            const bool is_off = !srdos_.empty() && random_.OneIn(8U);
            srdo.direction = is_off ? 0U : 1U + random_.Below(2U);
            srdo.is_static = kind_ == 2U || (kind_ != 0U && random_.OneIn(3U));
            ChoosePairs(srdo);
            srdos_.push_back(srdo);
        }
    }

    void ChoosePairs(Srdo& srdo)
    {
        const bool is_full = kind_ == 0U && srdos_.empty();
        const std::uint32_t most = is_full ? 64U : 1U + random_.Below(5U);
        std::uint32_t left = 64U;
        for (std::uint32_t count = 0U; count < most && left != 0U; ++count)
        {
            Pair pair;
            const bool in_bits = has_bits_ && !srdo.is_static;
            const std::uint32_t bytes = 1U + random_.Below(left / 8U == 0U ? 1U : left / 8U);
            pair.bits = is_full ? 1U : (in_bits ? 1U + random_.Below(left < 8U ? left : 8U) : bytes * 8U);
            if (pair.bits > left)
            {
                break;
            }
            const bool may_be_dummy = srdo.direction == 2U && !srdo.is_static && pair.bits == 8U;
            pair.is_dummy = may_be_dummy && count != 0U && random_.OneIn(2U);
            pair.value = random_.Next() >> (64U - pair.bits);
            if (srdo.direction == 2U)
            {
                srdo.safe_value |= pair.value << (64U - left);
            }
            left -= pair.bits;
            srdo.pairs.push_back(pair);
        }
    }

    static std::string Head(const std::uint32_t index)
    {
        return HexText(index, 4).substr(2U);
    }

    static std::string Sub(const std::uint32_t index, const std::uint32_t sub)
    {
        return Head(index) + "sub" + HexText(sub, 1).substr(2U);
    }

    void AppendObject(const std::uint32_t index, const std::string& name, const std::uint32_t highest)
    {
        text_ += "[" + Head(index) + "]\nParameterName=" + name + "\nObjectType=0x8\n\n";
        text_ += Section(Sub(index, 0U), "Highest sub-index supported", 5U, "const", std::to_string(highest));
    }

    void AppendCommunication(const Srdo& srdo)
    {
        const std::uint32_t index = 0x1300U + srdo.number;
        const std::uint32_t srvt_ms = 1U + random_.Below(20U);
        AppendObject(index, "SRDO communication parameter", 6U);
        text_ += Section(Sub(index, 1U), "Direction", 5U, "rw", std::to_string(srdo.direction));
        text_ += Section(Sub(index, 2U), "SCT", 6U, "rw", std::to_string(srvt_ms + 1U + random_.Below(500U)));
        text_ += Section(Sub(index, 3U), "SRVT", 5U, "rw", std::to_string(srvt_ms));
        text_ += Section(Sub(index, 4U), "Transmission type", 5U, "const", "254");
        text_ += Section(Sub(index, 5U), "COB-ID 1", 7U, "rw", HexText(0xFFU + 2U * srdo.number, 3));
        text_ += Section(Sub(index, 6U), "COB-ID 2", 7U, "rw", HexText(0x100U + 2U * srdo.number, 3));
    }

    static std::uint32_t ObjectOf(const Srdo& srdo, const bool is_normal)
    {
        return 0x2000U + srdo.number * 4U + (is_normal ? 0U : 2U);
    }

    void AppendMapping(const Srdo& srdo)
    {
        const std::uint32_t index = 0x1380U + srdo.number;
        const std::string access = srdo.is_static ? "const" : "rw";
        text_ += "[" + Head(index) + "]\nParameterName=SRDO mapping parameter\nObjectType=0x8\n\n";
        text_ += Section(Sub(index, 0U), "Number of entries", 5U, access, std::to_string(2U * srdo.pairs.size()));
        std::uint32_t sub = 0U;
        for (const Pair& pair : srdo.pairs)
        {
            for (const bool is_normal : {true, false})
            {
                ++sub;
                const std::uint32_t object = (ObjectOf(srdo, is_normal) << 8U) | ((sub + 1U) / 2U);
                const std::uint32_t entry = pair.is_dummy ? 0x00050008U : (object << 8U) | pair.bits;
                text_ += Section(Sub(index, sub), "Entry", 7U, access, HexText(entry, 8));
            }
        }
    }

    void AppendVariables(const Srdo& srdo)
    {
        const char* const sent[] = {"ro", "rwr", "rw"};
        const char* const received[] = {"wo", "rww", "rw"};
        std::string inverse;
        AppendObject(ObjectOf(srdo, true), "Data", static_cast<std::uint32_t>(srdo.pairs.size()));
        for (std::uint32_t sub = 1U; sub <= srdo.pairs.size(); ++sub)
        {
            const Pair& pair = srdo.pairs[sub - 1U];
            const std::uint32_t type = TypeOf(random_, pair.bits);
            const std::string access = srdo.direction == 2U ? received[random_.Below(3U)] : sent[random_.Below(3U)];
            const std::uint64_t complement = ~pair.value & (~std::uint64_t{0U} >> (64U - pair.bits));
            const std::string inverse_object = HexText((ObjectOf(srdo, false) << 8U) | sub, 6);
            text_ += Section(Sub(ObjectOf(srdo, true), sub), "Value", type, access, HexText(pair.value, 1),
                             "SRDOMapping=1\nInvertedSRAD=" + inverse_object + "\n");
            inverse += Section(Sub(ObjectOf(srdo, false), sub), "Value", type, access, HexText(complement, 1),
                               "SRDOMapping=1\n");
        }
        AppendObject(ObjectOf(srdo, false), "Data, inverse", static_cast<std::uint32_t>(srdo.pairs.size()));
        text_ += inverse;
    }

    void AppendSignatures()
    {
        text_ += Section("13FE", "Configuration valid", 5U, "rw", "0xA5");
        AppendObject(0x13FFU, "Signature", srdos_.back().number);
        for (const Srdo& srdo : srdos_)
        {
            text_ += Section(Sub(0x13FFU, srdo.number), "Signature", 6U, "rw", "0");
        }
    }

    void AppendParameters()
    {
        text_ += "[5F00]\nParameterName=Device parameters\nObjectType=0x9\n\n";
        text_ += Section("5F00sub0", "Highest sub-index supported", 5U, "const", "12");
        text_ += Section("5F00subA", "Granularity", 5U, "rw", has_bits_ ? "1" : "8");
        text_ += Section("5F00subC", "Dummy mapping", 5U, "rw", "0x66");
        AppendObject(0x5F01U, "Release policy", 64U);
        AppendObject(0x5F02U, "Safe value", 64U);
        AppendObject(0x5F03U, "Producer form", 64U);
        AppendObject(0x5F05U, "SRVT detection", 64U);
        for (const Srdo& srdo : srdos_)
        {
            text_ += Section(Sub(0x5F01U, srdo.number), "Policy", 5U, "rw", random_.OneIn(2U) ? "0x5A" : "0");
            text_ += Section(Sub(0x5F02U, srdo.number), "Value", 0x1BU, "rw", HexText(srdo.safe_value, 1));
            text_ += Section(Sub(0x5F03U, srdo.number), "Form", 5U, "rw", std::to_string(random_.Below(2U)));
            text_ += Section(Sub(0x5F05U, srdo.number), "Detection", 5U, "rw", random_.OneIn(2U) ? "0x3C" : "0");
        }
        text_ += Section("5F04", "Device digest", 7U, "rw", "0");
    }

    Random random_;
    std::uint64_t kind_;
    bool has_bits_{false};
    std::vector<Srdo> srdos_;
    std::string text_;
};
} // namespace

std::string RandomDevice(const std::uint64_t seed)
{
    const cia306::IniDocument document = cia306::IniDocument::Parse("random.dcf", Writer(seed).Text());
    const cia306::Device device = cia306::ReadDevice(document);
    return cia306::WithSignatures(document, device, device.node_id).Text();
}
} // namespace counterpoint::generate::test
