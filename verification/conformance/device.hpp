// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_DEVICE_HPP
#define VERIFICATION_CONFORMANCE_DEVICE_HPP

#include "safety_core/contract/configuration.hpp"

#include <cstdint>

namespace counterpoint::conformance
{

/// What a master writes to 130xh, 138xh and 13FFh of one SRDO. Transmission type stays 254.
struct SrdoValues
{
    std::uint8_t direction;
    std::uint16_t sct_ms; ///< Refresh time of a producer.
    std::uint8_t srvt_ms;
    std::uint32_t cob_id_1;
    std::uint32_t cob_id_2;
    std::uint8_t map_count;
    const std::uint32_t* entries;
    std::uint16_t signature;
    std::uint32_t normal_field{0U}; ///< With a static mapping: objects by Place at which its fields begin.
    std::uint32_t inverse_field{0U};
};

/// Stands in DeviceConfig::object_count of a case's device for "all objects of the dictionary".
constexpr std::uint16_t kAllObjects = 0xFFFFU;

/// A device of the cases: its fixed description, of which the runner fills in `objects`, and the values that
/// Step Configure stores, one set for each slot.
struct Device
{
    DeviceConfig config;
    const SrdoValues* values;
};

// Consumers. Unless said otherwise: node-ID 40, granularity 8 bits, both frames on the first controller, cycle and
// tolerance 1 s each (no call is late), acknowledge window 100 ms. "Gold" is the configuration that the manual of a
// certified scanner publishes: SCT 50 ms, SRVT 20 ms, 111h and 112h, 6010h:01, 02 and 6011h:01, 02 of 8 bits, safe
// value A5h, C3h.
extern const Device kGold;       ///< One SRDO, automatic.
extern const Device kGoldLocked; ///< One SRDO, restart interlock.
extern const Device kGoldOther;  ///< One SRDO, a policy value that is neither.
extern const Device kGoldPrompt; ///< Automatic; cycle 10 ms, tolerance 5 ms.
extern const Device kGoldPorts;  ///< Automatic; inverse frames on the second controller.
extern const Device kTwo; ///< Numbers 1 and 3: gold, and 103h/104h with 6200h:01, 6201h:01 of 32 bits; both automatic.
extern const Device kTwoLocked; ///< The same with restart interlock.
extern const Device kWide;      ///< 16 entries of 8 bits (6631h, 6633h), 17Fh/180h, SCT 10 ms, SRVT 5 ms; automatic.
extern const Device
    kLong; ///< One object of 64 bits (6300h:08, 6301h:08), 105h/106h, SCT 65535 ms, SRVT 255 ms; automatic.
extern const Device kMixedSizes; ///< 6300h:03 (24 bits), 6300h:02 (16), 6300h:01 (8); 107h/108h; automatic.
extern const Device kShortest;   ///< SCT 2 ms, SRVT 1 ms, 6300h:01; automatic.

// Producers: cycle 1 ms, tolerance 0.5 ms, refresh 25 ms, SRVT 20 ms, 101h/102h, 6210h:01, 02 and 6211h:01, 02 of 8
// bits.
extern const Device kSender;        ///< Node-ID 4, the application sends.
extern const Device kProvider;      ///< Node-ID 4, the kernel calls.
extern const Device kProviderLast;  ///< Node-ID 127, the kernel calls.
extern const Device kSenderPorts;   ///< As kSender, inverse frames on the second controller.
extern const Device kSenderSwapped; ///< As kSender, normal frames on the second controller, inverse ones on the first.
extern const Device kSenderSlow;    ///< As kSender, cycle 2.5 ms.
extern const Device
    kWideSender; ///< As kSender, 16 entries of 8 bits (6621h, 6623h), 17Fh/180h, refresh 10 ms, SRVT 5 ms.
extern const Device kWordSender; ///< As kSender, 6400h, 6401h:04, 03, 01 (32, 24, 8 bits).
extern const Device kLongSender; ///< As kSender, 6400h, 6401h:08 (64 bits).
extern const Device kOddSender;  ///< As kSender, 6400h, 6401h:07 (56 bits).
extern const Device kSenders;    ///< 16 SRDOs like that of kSender, of the same objects, 101h/102h to 11Fh/120h.
extern const Device kMixed;      ///< Slot 0 consumer gold, automatic; slot 1 producer of kSender; slot 2 off.

// Configuration and size.
extern const Device kBare;    ///< One SRDO, node-ID 40, cycle 1 ms; Configure stores nothing but direction 0.
extern const Device kBareTwo; ///< Two SRDOs, numbers 1 and 2.
extern const Device kNode1;   ///< Two SRDOs (1, 2), node-ID 1; likewise 32, 33, 64, 65, 127.
extern const Device kNode32;
extern const Device kNode33;
extern const Device kNode64;
extern const Device kNode65;
extern const Device kNode127;
extern const Device kSecondOnly; ///< One SRDO, number 2, node-ID 40.
extern const Device kCoarse16;   ///< kBare with granularity 16 bits; likewise 32 and 64.
extern const Device kCoarse32;
extern const Device kCoarse64;
extern const Device kNoObjects; ///< kBare without a mappable object.
extern const Device kOneObject; ///< kBare with the first object of the dictionary only.
extern const Device kSixtyFour; ///< 64 consumers of two 32-bit objects, 101h/102h to 17Fh/180h, SCT 50 ms, SRVT 20 ms.
extern const Device kGaps;      ///< Numbers 2, 17, 33, 64; consumer, off, consumer, off.

// Whole width: granularity 1 bit, 128 entries; otherwise like gold (consumers) or kSender (producers).
extern const Device kBits3;        ///< 6302h, 6303h:03.
extern const Device kBitRow;       ///< Of 3, 12, 1 and 7 bits: 6302h, 6303h:03, 0C, 01, 07.
extern const Device kBits64;       ///< 64 objects of one bit, 6304h, 6305h:01 to 40.
extern const Device kBits63;       ///< 6302h, 6303h:3F.
extern const Device kBitsSplit;    ///< Of 33 and 31 bits: 6302h, 6303h:21, 1F.
extern const Device kBitRowSender; ///< 6402h, 6403h:03, 0C, 01, 07.
extern const Device kBits64Sender; ///< 6404h, 6405h:01 to 40.
extern const Device kBits63Sender; ///< 6402h, 6403h:3F.
extern const Device kSplitSender;  ///< 6402h, 6403h:21, 1F.
extern const Device kBareBits;     ///< kBare with granularity 1 bit and 128 entries.
extern const Device kBareDummies;  ///< The same with dummies.
extern const Device kDummies;      ///< 8 bits, dummy of 8, 8 bits, dummies of 1 and 32: 6010h, 6011h:01, 02.

// Late detection.
extern const Device kGoldLate;       ///< kGold.
extern const Device kGoldLatePrompt; ///< kGoldPrompt.
extern const Device kTwoLate;        ///< kTwo: the first early, the second late.
extern const Device kGoldNoLate;     ///< kGold with a detection that is neither.

// Static mappings, with right fields unless said otherwise; no room for dynamic entries.
extern const Device kStatic;       ///< Gold.
extern const Device kStaticSender; ///< kSender.
extern const Device kStaticSizes;  ///< 6300h, 6301h:01 to 03: 8, 16 and 24 bits.
extern const Device kStaticGap;    ///< 6300h, 6301h:01 and 03.
extern const Device kStaticFirst;  ///< 6631h:01, 02 and 6633h:01, 03: a gap in the inverse field only.
extern const Device kStaticTurned; ///< 6631h, 6633h:02, 01.
extern const Device kStaticBits;   ///< 6302h, 6303h:04, granularity 1 bit.
extern const Device kStaticDummy;  ///< 6010h, 6011h:01 and a dummy pair, dummies allowed.
extern const Device kStaticEmpty;  ///< No entry.
extern const Device kStaticOdd;    ///< Three entries.
extern const Device kStaticLarge;  ///< 130 entries of one bit.
extern const Device kStaticLong;   ///< 6300h, 6301h:01 to 04: 80 bits.
extern const Device kStaticUneven; ///< 6300h:01 (8 bits) and 6301h:02 (16).
extern const Device kStaticSame;   ///< 6010h:01 on both sides, and both fields there.
extern const Device kStaticTwo;    ///< Slot 0 static gold, slot 1 dynamic, 6200h, 6201h:01; room for 16 entries.
extern const Device kStaticAbove;  ///< The other way round.
extern const Device kStaticTwins;  ///< Twice static gold, the second with 103h/104h.

} // namespace counterpoint::conformance

#endif
