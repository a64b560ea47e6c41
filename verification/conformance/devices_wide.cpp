// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Devices with objects of any length, dummy entries, static mappings and late detection. Signatures were computed
// outside this program.
#include "verification/conformance/device_parts.hpp"

namespace counterpoint::conformance
{

namespace
{
constexpr std::uint8_t kBitEntries = 128U;
constexpr std::uint32_t kLargeCount = 130U;

struct OneBitMap
{
    std::uint32_t entries[kLargeCount];
};

/// Objects of one bit, sub-index 1 onward, normal and inverse in turn; the pair behind the last one is named twice.
constexpr OneBitMap MakeOneBitMap(std::uint32_t normal_index)
{
    OneBitMap map{};
    for (std::uint32_t i = 0U; i < kLargeCount; ++i)
    {
        const std::uint32_t sub = (i < kBitEntries) ? ((i / 2U) + 1U) : 64U;
        map.entries[i] = ((normal_index + (i % 2U)) << 16U) | (sub << 8U) | 1U;
    }
    return map;
}

constexpr std::uint32_t kBits3Map[] = {0x63020303U, 0x63030303U};
constexpr std::uint32_t kBitRowMap[] = {0x63020303U, 0x63030303U, 0x63020C0CU, 0x63030C0CU,
                                        0x63020101U, 0x63030101U, 0x63020707U, 0x63030707U};
constexpr OneBitMap kBits64Map = MakeOneBitMap(0x6304U);
constexpr std::uint32_t kBits63Map[] = {0x63023F3FU, 0x63033F3FU};
constexpr std::uint32_t kSplitMap[] = {0x63022121U, 0x63032121U, 0x63021F1FU, 0x63031F1FU};
constexpr std::uint32_t kBitRowSenderMap[] = {0x64020303U, 0x64030303U, 0x64020C0CU, 0x64030C0CU,
                                              0x64020101U, 0x64030101U, 0x64020707U, 0x64030707U};
constexpr OneBitMap kBits64SenderMap = MakeOneBitMap(0x6404U);
constexpr std::uint32_t kBits63SenderMap[] = {0x64023F3FU, 0x64033F3FU};
constexpr std::uint32_t kSplitSenderMap[] = {0x64022121U, 0x64032121U, 0x64021F1FU, 0x64031F1FU};
constexpr std::uint32_t kDummiesMap[] = {0x60100108U, 0x60110108U, 0x00050008U, 0x00050008U, 0x60100208U,
                                         0x60110208U, 0x00010001U, 0x00010001U, 0x00040020U, 0x00070020U};

constexpr SrdoValues kBits3Values{2U, 50U, 20U, 0x111U, 0x112U, 2U, kBits3Map, 0x49D6U};
constexpr SrdoValues kBitRowValues{2U, 50U, 20U, 0x111U, 0x112U, 8U, kBitRowMap, 0x8A68U};
constexpr SrdoValues kBits64Values{2U, 50U, 20U, 0x111U, 0x112U, 128U, kBits64Map.entries, 0xA6CFU};
constexpr SrdoValues kBits63Values{2U, 50U, 20U, 0x111U, 0x112U, 2U, kBits63Map, 0x8CB0U};
constexpr SrdoValues kSplitValues{2U, 50U, 20U, 0x111U, 0x112U, 4U, kSplitMap, 0x2866U};
constexpr SrdoValues kBitRowSenderValues{1U, 25U, 20U, 0x101U, 0x102U, 8U, kBitRowSenderMap, 0xC18CU};
constexpr SrdoValues kBits64SenderValues{1U, 25U, 20U, 0x101U, 0x102U, 128U, kBits64SenderMap.entries, 0x7284U};
constexpr SrdoValues kBits63SenderValues{1U, 25U, 20U, 0x101U, 0x102U, 2U, kBits63SenderMap, 0x67BAU};
constexpr SrdoValues kSplitSenderValues{1U, 25U, 20U, 0x101U, 0x102U, 4U, kSplitSenderMap, 0x2BFFU};
constexpr SrdoValues kDummiesValues{2U, 50U, 20U, 0x111U, 0x112U, 10U, kDummiesMap, 0x3679U};

constexpr SrdoSetup Safe(std::uint32_t low, std::uint32_t high)
{
    return Consumer(1U, ReleasePolicy::kAutomatic, Payload{low, high});
}

constexpr SrdoSetup Late(SrdoSetup setup, SrvtDetection detection = SrvtDetection::kLate)
{
    setup.detection = detection;
    return setup;
}

constexpr SrdoSetup Fixed(SrdoSetup setup, const std::uint32_t* entries, std::uint8_t count)
{
    setup.map = StaticMap{entries, count};
    return setup;
}

constexpr SrdoSetup kBits3Setups[] = {Safe(0x5U, 0U)};
constexpr SrdoSetup kBitRowSetups[] = {Safe(0x2D53F4U, 0U)};
constexpr SrdoSetup kFullSetups[] = {Safe(0x04030201U, 0x08070605U)};
constexpr SrdoSetup kBits63Setups[] = {Safe(0x04030201U, 0x78070605U)};
constexpr SrdoSetup kGoldSetups[] = {Safe(0xC3A5U, 0U)};
constexpr SrdoSetup kDummiesSetups[] = {Safe(0x00C300A5U, 0U)};
constexpr SrdoSetup kSenderSetups[] = {Producer(1U, ProducerForm::kApplicationSends)};

constexpr SrdoSetup kLateSetups[] = {Late(Safe(0xC3A5U, 0U))};
constexpr SrdoSetup kNoLateSetups[] = {Late(Safe(0xC3A5U, 0U), static_cast<SrvtDetection>(0x3DU))};
constexpr SrdoSetup kTwoLateSetups[] = {Consumer(1U, ReleasePolicy::kAutomatic, kGoldSafe),
                                        Late(Consumer(3U, ReleasePolicy::kAutomatic, kWordSafe))};
constexpr SrdoValues kTwoLateValues[] = {kGoldValues, kWordValues};

// ---- static mappings

constexpr std::uint32_t kSizesMap[] = {0x63000108U, 0x63010108U, 0x63000210U, 0x63010210U,
                                       0x63000318U, 0x63010318U, 0x63000420U, 0x63010420U};
constexpr std::uint32_t kGapMap[] = {0x63000108U, 0x63010108U, 0x63000318U, 0x63010318U};
constexpr std::uint32_t kFirstMap[] = {0x66310108U, 0x66330108U, 0x66310208U, 0x66330308U};
constexpr std::uint32_t kUnequalMap[] = {0x63000108U, 0x63010210U};
constexpr std::uint32_t kSameMap[] = {0x60100108U, 0x60100108U};
constexpr std::uint32_t kTurnedMap[] = {0x66310208U, 0x66330208U, 0x66310108U, 0x66330108U};
constexpr std::uint32_t kFourBitsMap[] = {0x63020404U, 0x63030404U};
constexpr std::uint32_t kStaticDummyMap[] = {0x60100108U, 0x60110108U, 0x00050008U, 0x00050008U};

constexpr SrdoSetup kStaticSetups[] = {Fixed(Safe(0xC3A5U, 0U), kGoldMap, 4U)};
constexpr SrdoSetup kStaticSenderSetups[] = {Fixed(Producer(1U, ProducerForm::kApplicationSends), kSenderMap, 4U)};
constexpr SrdoSetup kStaticSizesSetups[] = {Fixed(Safe(0x04030201U, 0x0605U), kSizesMap, 6U)};
constexpr SrdoSetup kStaticGapSetups[] = {Fixed(Safe(0U, 0U), kGapMap, 4U)};
constexpr SrdoSetup kStaticFirstSetups[] = {Fixed(Safe(0U, 0U), kFirstMap, 4U)};
constexpr SrdoSetup kStaticTurnedSetups[] = {Fixed(Safe(0U, 0U), kTurnedMap, 4U)};
constexpr SrdoSetup kStaticBitsSetups[] = {Fixed(Safe(0U, 0U), kFourBitsMap, 2U)};
constexpr SrdoSetup kStaticDummySetups[] = {Fixed(Safe(0U, 0U), kStaticDummyMap, 4U)};
constexpr SrdoSetup kStaticEmptySetups[] = {Fixed(Safe(0U, 0U), kGoldMap, 0U)};
constexpr SrdoSetup kStaticOddSetups[] = {Fixed(Safe(0U, 0U), kGoldMap, 3U)};
constexpr SrdoSetup kStaticLargeSetups[] = {Fixed(Safe(0U, 0U), kBits64Map.entries, kLargeCount)};
constexpr SrdoSetup kStaticLongSetups[] = {Fixed(Safe(0U, 0U), kSizesMap, 8U)};
constexpr SrdoSetup kStaticUnevenSetups[] = {Fixed(Safe(0U, 0U), kUnequalMap, 2U)};
constexpr SrdoSetup kStaticSameSetups[] = {Fixed(Safe(0U, 0U), kSameMap, 2U)};
constexpr SrdoSetup kStaticTwoSetups[] = {Fixed(Safe(0xC3A5U, 0U), kGoldMap, 4U),
                                          Consumer(3U, ReleasePolicy::kAutomatic, kWordSafe)};
constexpr SrdoSetup kGoldAbove = Fixed(Consumer(3U, ReleasePolicy::kAutomatic, kGoldSafe), kGoldMap, 4U);
constexpr SrdoSetup kStaticAboveSetups[] = {Consumer(1U, ReleasePolicy::kAutomatic, kWordSafe), kGoldAbove};
constexpr SrdoSetup kStaticTwinsSetups[] = {Fixed(Safe(0xC3A5U, 0U), kGoldMap, 4U), kGoldAbove};

constexpr std::uint32_t At(std::uint32_t index, std::uint32_t sub)
{
    return (index << 8U) | sub;
}

constexpr SrdoValues StaticValues(std::uint16_t signature, std::uint32_t normal_field, std::uint32_t inverse_field)
{
    return SrdoValues{2U, 50U, 20U, 0x111U, 0x112U, 0U, nullptr, signature, normal_field, inverse_field};
}

constexpr SrdoValues kStaticValues = StaticValues(0x4370U, At(0x6010U, 1U), At(0x6011U, 1U));
constexpr SrdoValues kStaticSenderValues{1U, 25U,     20U,     0x101U,          0x102U,
                                         0U, nullptr, 0xF2B5U, At(0x6210U, 1U), At(0x6211U, 1U)};
constexpr SrdoValues kStaticSizesValues = StaticValues(0xA563U, At(0x6300U, 1U), At(0x6301U, 1U));
constexpr SrdoValues kStaticGapValues = StaticValues(0x08A7U, At(0x6300U, 1U), At(0x6301U, 1U));
constexpr SrdoValues kStaticFirstValues = StaticValues(0x5A91U, At(0x6631U, 1U), At(0x6633U, 1U));
constexpr SrdoValues kStaticTurnedValues = StaticValues(0x3353U, At(0x6631U, 2U), At(0x6633U, 2U));
constexpr SrdoValues kStaticBitsValues = StaticValues(0xEBD8U, At(0x6302U, 4U), At(0x6303U, 4U));
constexpr SrdoValues kStaticDummyValues = StaticValues(0x1063U, At(0x6010U, 1U), At(0x6011U, 1U));
constexpr SrdoValues kStaticEmptyValues = StaticValues(0x251CU, At(0x6010U, 1U), At(0x6011U, 1U));
constexpr SrdoValues kStaticOddValues = StaticValues(0x4325U, At(0x6010U, 1U), At(0x6011U, 1U));
constexpr SrdoValues kStaticLargeValues = StaticValues(0xA6CFU, At(0x6304U, 1U), At(0x6305U, 1U));
constexpr SrdoValues kStaticLongValues = StaticValues(0x5C6AU, At(0x6300U, 1U), At(0x6301U, 1U));
constexpr SrdoValues kStaticUnevenValues = StaticValues(0x7301U, At(0x6300U, 1U), At(0x6301U, 2U));
constexpr SrdoValues kStaticSameValues = StaticValues(0x4D8FU, At(0x6010U, 1U), At(0x6010U, 1U));
constexpr SrdoValues kStaticTwoValues[] = {kStaticValues, kWordValues};
constexpr SrdoValues kStaticAboveValues[] = {kWordValues, kStaticValues};
constexpr SrdoValues kTwinValues{2U, 50U, 20U, 0x103U, 0x104U, 0U, nullptr, 0xDB4FU, At(0x6010U, 1U), At(0x6011U, 1U)};
constexpr SrdoValues kStaticTwinsValues[] = {kStaticValues, kTwinValues};

constexpr DeviceConfig Grained(DeviceConfig config)
{
    config.granularity_bits = 1U;
    config.map_entries = kBitEntries;
    return config;
}

constexpr DeviceConfig WithDummies(DeviceConfig config)
{
    config.dummies = DummyMapping::kAllowed;
    return config;
}

constexpr DeviceConfig NoEntries(DeviceConfig config)
{
    config.map_entries = 0U;
    return config;
}

constexpr DeviceConfig kSendingBits = Grained(Node(Every(Config(kSenderSetups), 1000U, 500U), 4U));
constexpr DeviceConfig kSendingStatic = NoEntries(Node(Every(Config(kStaticSenderSetups), 1000U, 500U), 4U));
} // namespace

const Device kBits3{Grained(Config(kBits3Setups)), &kBits3Values};
const Device kBitRow{Grained(Config(kBitRowSetups)), &kBitRowValues};
const Device kBits64{Grained(Config(kFullSetups)), &kBits64Values};
const Device kBits63{Grained(Config(kBits63Setups)), &kBits63Values};
const Device kBitsSplit{Grained(Config(kFullSetups)), &kSplitValues};
const Device kBitRowSender{kSendingBits, &kBitRowSenderValues};
const Device kBits64Sender{kSendingBits, &kBits64SenderValues};
const Device kBits63Sender{kSendingBits, &kBits63SenderValues};
const Device kSplitSender{kSendingBits, &kSplitSenderValues};
const Device kBareBits{Grained(Config(kGoldSetups)), &kBareValues};
const Device kBareDummies{WithDummies(Grained(Config(kGoldSetups))), &kBareValues};
const Device kDummies{WithDummies(Grained(Config(kDummiesSetups))), &kDummiesValues};

const Device kGoldLate{Config(kLateSetups), &kGoldValues};
const Device kGoldLatePrompt{Every(Config(kLateSetups), 10000U, 5000U), &kGoldValues};
const Device kTwoLate{Config(kTwoLateSetups), kTwoLateValues};
const Device kGoldNoLate{Config(kNoLateSetups), &kGoldValues};

const Device kStatic{NoEntries(Config(kStaticSetups)), &kStaticValues};
const Device kStaticSender{kSendingStatic, &kStaticSenderValues};
const Device kStaticSizes{NoEntries(Config(kStaticSizesSetups)), &kStaticSizesValues};
const Device kStaticGap{NoEntries(Config(kStaticGapSetups)), &kStaticGapValues};
const Device kStaticFirst{NoEntries(Config(kStaticFirstSetups)), &kStaticFirstValues};
const Device kStaticTurned{NoEntries(Config(kStaticTurnedSetups)), &kStaticTurnedValues};
const Device kStaticBits{NoEntries(Grained(Config(kStaticBitsSetups))), &kStaticBitsValues};
const Device kStaticDummy{NoEntries(WithDummies(Config(kStaticDummySetups))), &kStaticDummyValues};
const Device kStaticEmpty{NoEntries(Config(kStaticEmptySetups)), &kStaticEmptyValues};
const Device kStaticOdd{NoEntries(Config(kStaticOddSetups)), &kStaticOddValues};
const Device kStaticLarge{NoEntries(Grained(Config(kStaticLargeSetups))), &kStaticLargeValues};
const Device kStaticLong{NoEntries(Config(kStaticLongSetups)), &kStaticLongValues};
const Device kStaticUneven{NoEntries(Config(kStaticUnevenSetups)), &kStaticUnevenValues};
const Device kStaticSame{NoEntries(Config(kStaticSameSetups)), &kStaticSameValues};
const Device kStaticTwo{Config(kStaticTwoSetups), kStaticTwoValues};
const Device kStaticAbove{Config(kStaticAboveSetups), kStaticAboveValues};
const Device kStaticTwins{Config(kStaticTwinsSetups), kStaticTwinsValues};

} // namespace counterpoint::conformance
