// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/conformance/device_parts.hpp"

#include <cstddef>

namespace counterpoint::conformance
{

namespace
{
constexpr std::uint32_t kWideMap[] = {0x66310108U, 0x66330108U, 0x66310208U, 0x66330208U, 0x66310308U, 0x66330308U,
                                      0x66310408U, 0x66330408U, 0x66310508U, 0x66330508U, 0x66310608U, 0x66330608U,
                                      0x66310708U, 0x66330708U, 0x66310808U, 0x66330808U};
constexpr std::uint32_t kLongMap[] = {0x63000840U, 0x63010840U};
constexpr std::uint32_t kMixedSizesMap[] = {0x63000318U, 0x63010318U, 0x63000210U,
                                            0x63010210U, 0x63000108U, 0x63010108U};
constexpr std::uint32_t kByteMap[] = {0x63000108U, 0x63010108U};

constexpr SrdoValues kWideValues{2U, 10U, 5U, 0x17FU, 0x180U, 16U, kWideMap, 0x72C4U};
constexpr SrdoValues kLongValues{2U, 65535U, 255U, 0x105U, 0x106U, 2U, kLongMap, 0x321DU};
constexpr SrdoValues kMixedSizesValues{2U, 50U, 20U, 0x107U, 0x108U, 6U, kMixedSizesMap, 0x7937U};
constexpr SrdoValues kShortestValues{2U, 2U, 1U, 0x109U, 0x10AU, 2U, kByteMap, 0x225EU};
constexpr std::uint32_t kWideSenderMap[] = {
    0x66210108U, 0x66230108U, 0x66210208U, 0x66230208U, 0x66210308U, 0x66230308U, 0x66210408U, 0x66230408U,
    0x66210508U, 0x66230508U, 0x66210608U, 0x66230608U, 0x66210708U, 0x66230708U, 0x66210808U, 0x66230808U};
constexpr std::uint32_t kWordSenderMap[] = {0x64000420U, 0x64010420U, 0x64000318U,
                                            0x64010318U, 0x64000108U, 0x64010108U};
constexpr std::uint32_t kLongSenderMap[] = {0x64000840U, 0x64010840U};
constexpr std::uint32_t kOddSenderMap[] = {0x64000738U, 0x64010738U};
constexpr SrdoValues kWideSenderValues{1U, 10U, 5U, 0x17FU, 0x180U, 16U, kWideSenderMap, 0xB825U};
constexpr SrdoValues kWordSenderValues{1U, 25U, 20U, 0x101U, 0x102U, 6U, kWordSenderMap, 0x82B7U};
constexpr SrdoValues kLongSenderValues{1U, 25U, 20U, 0x101U, 0x102U, 2U, kLongSenderMap, 0x05DEU};
constexpr SrdoValues kOddSenderValues{1U, 25U, 20U, 0x101U, 0x102U, 2U, kOddSenderMap, 0xB5BFU};
constexpr SrdoValues kOffValues{0U, 25U, 20U, 0x101U, 0x102U, 0U, nullptr, 0x88E9U};

/// Signatures of the 64 SRDOs of kSixtyFour, by bitwise long division over the published layout, outside this program.
constexpr std::uint16_t kSixtyFourSignatures[kMaxSrdoCount] = {
    0x766CU, 0x92DFU, 0xA2C9U, 0x4B98U, 0xCF07U, 0x2BB4U, 0x1BA2U, 0xE937U, 0x149BU, 0xF028U, 0xC03EU, 0x296FU, 0xADF0U,
    0x4943U, 0x7955U, 0xBC48U, 0xB382U, 0x5731U, 0x6727U, 0x8E76U, 0x0AE9U, 0xEE5AU, 0xDE4CU, 0x2CD9U, 0xD175U, 0x35C6U,
    0x05D0U, 0xEC81U, 0x681EU, 0x8CADU, 0xBCBBU, 0x16B6U, 0xED91U, 0x0922U, 0x3934U, 0xD065U, 0x54FAU, 0xB049U, 0x805FU,
    0x72CAU, 0x8F66U, 0x6BD5U, 0x5BC3U, 0xB292U, 0x360DU, 0xD2BEU, 0xE2A8U, 0x27B5U, 0x287FU, 0xCCCCU, 0xFCDAU, 0x158BU,
    0x9114U, 0x75A7U, 0x45B1U, 0xB724U, 0x4A88U, 0xAE3BU, 0x9E2DU, 0x777CU, 0xF3E3U, 0x1750U, 0x2746U, 0x536BU,
};

constexpr Payload kWideSafe{0x04030201U, 0x08070605U};

constexpr std::uint8_t kSendersCount = 16U;
constexpr ReleasePolicy kNeither = static_cast<ReleasePolicy>(0x5BU);

constexpr SrdoSetup kGoldSetups[] = {Consumer(1U, ReleasePolicy::kAutomatic, kGoldSafe)};
constexpr SrdoSetup kGoldLockedSetups[] = {Consumer(1U, ReleasePolicy::kInterlock, kGoldSafe)};
constexpr SrdoSetup kGoldOtherSetups[] = {Consumer(1U, kNeither, kGoldSafe)};
constexpr SrdoSetup kTwoSetups[] = {Consumer(1U, ReleasePolicy::kAutomatic, kGoldSafe),
                                    Consumer(3U, ReleasePolicy::kAutomatic, kWordSafe)};
constexpr SrdoSetup kTwoLockedSetups[] = {Consumer(1U, ReleasePolicy::kInterlock, kGoldSafe),
                                          Consumer(3U, ReleasePolicy::kInterlock, kWordSafe)};
constexpr SrdoSetup kWideSetups[] = {Consumer(1U, ReleasePolicy::kAutomatic, kWideSafe)};
constexpr SrdoSetup kSenderSetups[] = {Producer(1U, ProducerForm::kApplicationSends)};
constexpr SrdoSetup kProviderSetups[] = {Producer(1U, ProducerForm::kProviderCalled)};
constexpr SrdoSetup kMixedSetups[] = {Consumer(1U, ReleasePolicy::kAutomatic, kGoldSafe),
                                      Producer(2U, ProducerForm::kApplicationSends),
                                      Consumer(3U, ReleasePolicy::kAutomatic, kGoldSafe)};
constexpr SrdoSetup kBareSetups[] = {Consumer(1U, ReleasePolicy::kAutomatic, kGoldSafe),
                                     Consumer(2U, ReleasePolicy::kAutomatic, kGoldSafe)};
constexpr SrdoSetup kSecondSetups[] = {Consumer(2U, ReleasePolicy::kAutomatic, kGoldSafe)};
constexpr SrdoSetup kGapsSetups[] = {
    Consumer(2U, ReleasePolicy::kAutomatic, kGoldSafe), Consumer(17U, ReleasePolicy::kAutomatic, kGoldSafe),
    Consumer(33U, ReleasePolicy::kAutomatic, kWordSafe), Consumer(64U, ReleasePolicy::kAutomatic, kGoldSafe)};

struct SixtyFour
{
    std::uint32_t entries[kMaxSrdoCount][4U];
    SrdoSetup setups[kMaxSrdoCount];
};

constexpr SixtyFour MakeSixtyFourEntries()
{
    SixtyFour all{};
    for (std::uint32_t slot = 0U; slot < kMaxSrdoCount; ++slot)
    {
        const std::uint32_t index = (0x7000U + slot) << 16U;
        all.entries[slot][0U] = index | 0x0120U;
        all.entries[slot][1U] = index | 0x0320U;
        all.entries[slot][2U] = index | 0x0220U;
        all.entries[slot][3U] = index | 0x0420U;
        all.setups[slot] = Consumer(static_cast<std::uint8_t>(slot + 1U), ReleasePolicy::kAutomatic, kWideSafe);
    }
    return all;
}

constexpr SixtyFour kSixtyFourEntries = MakeSixtyFourEntries();

struct SixtyFourValues
{
    SrdoValues values[kMaxSrdoCount];
};

constexpr SixtyFourValues MakeSixtyFourValues()
{
    SixtyFourValues all{};
    for (std::uint32_t slot = 0U; slot < kMaxSrdoCount; ++slot)
    {
        all.values[slot] = SrdoValues{2U,
                                      50U,
                                      20U,
                                      0x101U + (2U * slot),
                                      0x102U + (2U * slot),
                                      4U,
                                      kSixtyFourEntries.entries[slot],
                                      kSixtyFourSignatures[slot]};
    }
    return all;
}

constexpr SixtyFourValues kSixtyFourValues = MakeSixtyFourValues();
constexpr SrdoValues kTwoValues[] = {kGoldValues, kWordValues};
constexpr SrdoValues kMixedValues[] = {kGoldValues, kSenderValues, kOffValues};
constexpr SrdoValues kBareTwoValues[] = {kBareValues, kBareValues};
constexpr SrdoValues kGapsValues[] = {kGoldValues, kOffValues, kWordValues, kOffValues};

/// Signatures of the 16 SRDOs of kSenders, computed like those above.
constexpr std::uint16_t kSendersSignatures[kSendersCount] = {0xF2B5U, 0x8EC1U, 0x07BFU, 0x7629U, 0x0880U, 0x74F4U,
                                                             0xFD8AU, 0x97D8U, 0x16FEU, 0x6A8AU, 0xE3F4U, 0x9262U,
                                                             0xECCBU, 0x90BFU, 0x19C1U, 0x441BU};

struct Senders
{
    SrdoValues values[kSendersCount];
    SrdoSetup setups[kSendersCount];
};

constexpr Senders MakeSenders()
{
    Senders all{};
    for (std::uint32_t slot = 0U; slot < kSendersCount; ++slot)
    {
        all.values[slot] = SrdoValues{
            1U, 25U, 20U, 0x101U + (2U * slot), 0x102U + (2U * slot), 4U, kSenderMap, kSendersSignatures[slot]};
        all.setups[slot] = Producer(static_cast<std::uint8_t>(slot + 1U), ProducerForm::kApplicationSends);
    }
    return all;
}

constexpr Senders kSendersData = MakeSenders();

constexpr DeviceConfig kSending = Node(Every(Config(kSenderSetups), 1000U, 500U), 4U);
constexpr DeviceConfig kProviding = Node(Every(Config(kProviderSetups), 1000U, 500U), 4U);
} // namespace

const Device kGold{Config(kGoldSetups), &kGoldValues};
const Device kGoldLocked{Config(kGoldLockedSetups), &kGoldValues};
const Device kGoldOther{Config(kGoldOtherSetups), &kGoldValues};
const Device kGoldPrompt{Every(Config(kGoldSetups), 10000U, 5000U), &kGoldValues};
const Device kGoldPorts{OnTwoPorts(Config(kGoldSetups)), &kGoldValues};
const Device kTwo{Config(kTwoSetups), kTwoValues};
const Device kTwoLocked{Config(kTwoLockedSetups), kTwoValues};
const Device kWide{Config(kWideSetups), &kWideValues};
const Device kLong{Config(kWideSetups), &kLongValues};
const Device kMixedSizes{Config(kWideSetups), &kMixedSizesValues};
const Device kShortest{Config(kGoldSetups), &kShortestValues};
const Device kSender{kSending, &kSenderValues};
const Device kProvider{kProviding, &kSenderValues};
const Device kProviderLast{Node(kProviding, 127U), &kSenderValues};
const Device kSenderPorts{OnTwoPorts(kSending), &kSenderValues};
const Device kSenderSwapped{OnSwappedPorts(kSending), &kSenderValues};
const Device kSenderSlow{Every(kSending, 2500U, 500U), &kSenderValues};
const Device kWideSender{kSending, &kWideSenderValues};
const Device kWordSender{kSending, &kWordSenderValues};
const Device kLongSender{kSending, &kLongSenderValues};
const Device kOddSender{kSending, &kOddSenderValues};
const Device kSenders{Node(Every(Config(kSendersData.setups), 1000U, 500U), 4U), kSendersData.values};
const Device kMixed{Node(Every(Config(kMixedSetups), 1000U, 1000000U), 4U), kMixedValues};
const Device kBare{Every(Config(kBareSetups, 1U), 1000U, 500U), kBareTwoValues};
const Device kBareTwo{Every(Config(kBareSetups), 1000U, 500U), kBareTwoValues};
const Device kNode1{Node(Config(kBareSetups), 1U), kBareTwoValues};
const Device kNode32{Node(Config(kBareSetups), 32U), kBareTwoValues};
const Device kNode33{Node(Config(kBareSetups), 33U), kBareTwoValues};
const Device kNode64{Node(Config(kBareSetups), 64U), kBareTwoValues};
const Device kNode65{Node(Config(kBareSetups), 65U), kBareTwoValues};
const Device kNode127{Node(Config(kBareSetups), 127U), kBareTwoValues};
const Device kSecondOnly{Config(kSecondSetups), kBareTwoValues};
const Device kCoarse16{Coarse(Config(kBareSetups, 1U), 16U), kBareTwoValues};
const Device kCoarse32{Coarse(Config(kBareSetups, 1U), 32U), kBareTwoValues};
const Device kCoarse64{Coarse(Config(kBareSetups, 1U), 64U), kBareTwoValues};
const Device kNoObjects{Objects(Config(kBareSetups, 1U), 0U), kBareTwoValues};
const Device kOneObject{Objects(Config(kBareSetups, 1U), 1U), kBareTwoValues};
const Device kSixtyFour{Config(kSixtyFourEntries.setups), kSixtyFourValues.values};
const Device kGaps{Config(kGapsSetups), kGapsValues};

} // namespace counterpoint::conformance
