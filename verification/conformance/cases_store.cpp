// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Power-on values, Store and Load.
#include "verification/conformance/gold.hpp"
#include "verification/conformance/stores.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr ConfigFault kSound = ConfigFault::kNone;

constexpr Step kDefaults1[] = {
    Load(0U, ConfigField::kDirection, 0U), Load(0U, ConfigField::kSct, 25U), Load(0U, ConfigField::kSrvt, 20U),
    Load(0U, ConfigField::kTransmissionType, 254U),
    Load(0U, ConfigField::kCobId1, 0x101U), Load(0U, ConfigField::kCobId2, 0x102U),
    Load(0U, ConfigField::kMapCount, 0U), Load(0U, ConfigField::kSignature, 0U),
    Load(1U, ConfigField::kDirection, 0U), Load(1U, ConfigField::kSct, 25U), Load(1U, ConfigField::kSrvt, 20U),
    Load(1U, ConfigField::kTransmissionType, 254U),
    Load(1U, ConfigField::kCobId1, 0x0U), Load(1U, ConfigField::kCobId2, 0x0U), Load(1U, ConfigField::kMapCount, 0U),
    Load(1U, ConfigField::kSignature, 0U),
    Load(0U, ConfigField::kMapEntry, 0U, 1U), Load(0U, ConfigField::kMapEntry, 0U, 16U),
    Load(0U, ConfigField::kGfcParameter, 0U),
    Load(0U, ConfigField::kConfigurationValid, 0U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
    Slot(1U, kOff, kNoCause, 0U, 0U, 0U),
};

constexpr Step kDefaults32[] = {
    Load(0U, ConfigField::kDirection, 0U), Load(0U, ConfigField::kSct, 25U), Load(0U, ConfigField::kSrvt, 20U),
    Load(0U, ConfigField::kTransmissionType, 254U),
    Load(0U, ConfigField::kCobId1, 0x13FU), Load(0U, ConfigField::kCobId2, 0x140U),
    Load(0U, ConfigField::kMapCount, 0U), Load(0U, ConfigField::kSignature, 0U),
    Load(1U, ConfigField::kDirection, 0U), Load(1U, ConfigField::kSct, 25U), Load(1U, ConfigField::kSrvt, 20U),
    Load(1U, ConfigField::kTransmissionType, 254U),
    Load(1U, ConfigField::kCobId1, 0x0U), Load(1U, ConfigField::kCobId2, 0x0U), Load(1U, ConfigField::kMapCount, 0U),
    Load(1U, ConfigField::kSignature, 0U),
    Load(0U, ConfigField::kMapEntry, 0U, 1U), Load(0U, ConfigField::kMapEntry, 0U, 16U),
    Load(0U, ConfigField::kGfcParameter, 0U),
    Load(0U, ConfigField::kConfigurationValid, 0U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
    Slot(1U, kOff, kNoCause, 0U, 0U, 0U),
};

constexpr Step kDefaults33[] = {
    Load(0U, ConfigField::kDirection, 0U), Load(0U, ConfigField::kSct, 50U), Load(0U, ConfigField::kSrvt, 20U),
    Load(0U, ConfigField::kTransmissionType, 254U),
    Load(0U, ConfigField::kCobId1, 0x141U), Load(0U, ConfigField::kCobId2, 0x142U),
    Load(0U, ConfigField::kMapCount, 0U), Load(0U, ConfigField::kSignature, 0U),
    Load(1U, ConfigField::kDirection, 0U), Load(1U, ConfigField::kSct, 25U), Load(1U, ConfigField::kSrvt, 20U),
    Load(1U, ConfigField::kTransmissionType, 254U),
    Load(1U, ConfigField::kCobId1, 0x0U), Load(1U, ConfigField::kCobId2, 0x0U), Load(1U, ConfigField::kMapCount, 0U),
    Load(1U, ConfigField::kSignature, 0U),
    Load(0U, ConfigField::kMapEntry, 0U, 1U), Load(0U, ConfigField::kMapEntry, 0U, 16U),
    Load(0U, ConfigField::kGfcParameter, 0U),
    Load(0U, ConfigField::kConfigurationValid, 0U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
    Slot(1U, kOff, kNoCause, 0U, 0U, 0U),
};

constexpr Step kDefaults64[] = {
    Load(0U, ConfigField::kDirection, 0U), Load(0U, ConfigField::kSct, 50U), Load(0U, ConfigField::kSrvt, 20U),
    Load(0U, ConfigField::kTransmissionType, 254U),
    Load(0U, ConfigField::kCobId1, 0x17FU), Load(0U, ConfigField::kCobId2, 0x180U),
    Load(0U, ConfigField::kMapCount, 0U), Load(0U, ConfigField::kSignature, 0U),
    Load(1U, ConfigField::kDirection, 0U), Load(1U, ConfigField::kSct, 25U), Load(1U, ConfigField::kSrvt, 20U),
    Load(1U, ConfigField::kTransmissionType, 254U),
    Load(1U, ConfigField::kCobId1, 0x0U), Load(1U, ConfigField::kCobId2, 0x0U), Load(1U, ConfigField::kMapCount, 0U),
    Load(1U, ConfigField::kSignature, 0U),
    Load(0U, ConfigField::kMapEntry, 0U, 1U), Load(0U, ConfigField::kMapEntry, 0U, 16U),
    Load(0U, ConfigField::kGfcParameter, 0U),
    Load(0U, ConfigField::kConfigurationValid, 0U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
    Slot(1U, kOff, kNoCause, 0U, 0U, 0U),
};

constexpr Step kDefaults65[] = {
    Load(0U, ConfigField::kDirection, 0U), Load(0U, ConfigField::kSct, 25U), Load(0U, ConfigField::kSrvt, 20U),
    Load(0U, ConfigField::kTransmissionType, 254U),
    Load(0U, ConfigField::kCobId1, 0x0U), Load(0U, ConfigField::kCobId2, 0x0U), Load(0U, ConfigField::kMapCount, 0U),
    Load(0U, ConfigField::kSignature, 0U),
    Load(1U, ConfigField::kDirection, 0U), Load(1U, ConfigField::kSct, 25U), Load(1U, ConfigField::kSrvt, 20U),
    Load(1U, ConfigField::kTransmissionType, 254U),
    Load(1U, ConfigField::kCobId1, 0x0U), Load(1U, ConfigField::kCobId2, 0x0U), Load(1U, ConfigField::kMapCount, 0U),
    Load(1U, ConfigField::kSignature, 0U),
    Load(0U, ConfigField::kMapEntry, 0U, 1U), Load(0U, ConfigField::kMapEntry, 0U, 16U),
    Load(0U, ConfigField::kGfcParameter, 0U),
    Load(0U, ConfigField::kConfigurationValid, 0U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
    Slot(1U, kOff, kNoCause, 0U, 0U, 0U),
};

constexpr Step kDefaults127[] = {
    Load(0U, ConfigField::kDirection, 0U), Load(0U, ConfigField::kSct, 25U), Load(0U, ConfigField::kSrvt, 20U),
    Load(0U, ConfigField::kTransmissionType, 254U),
    Load(0U, ConfigField::kCobId1, 0x0U), Load(0U, ConfigField::kCobId2, 0x0U), Load(0U, ConfigField::kMapCount, 0U),
    Load(0U, ConfigField::kSignature, 0U),
    Load(1U, ConfigField::kDirection, 0U), Load(1U, ConfigField::kSct, 25U), Load(1U, ConfigField::kSrvt, 20U),
    Load(1U, ConfigField::kTransmissionType, 254U),
    Load(1U, ConfigField::kCobId1, 0x0U), Load(1U, ConfigField::kCobId2, 0x0U), Load(1U, ConfigField::kMapCount, 0U),
    Load(1U, ConfigField::kSignature, 0U),
    Load(0U, ConfigField::kMapEntry, 0U, 1U), Load(0U, ConfigField::kMapEntry, 0U, 16U),
    Load(0U, ConfigField::kGfcParameter, 0U),
    Load(0U, ConfigField::kConfigurationValid, 0U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
    Slot(1U, kOff, kNoCause, 0U, 0U, 0U),
};

// The default connection belongs to SRDO number 1, not to slot 0.
constexpr Step kDefaultsOfNumber2[] = {
    Load(0U, ConfigField::kDirection, 0U), Load(0U, ConfigField::kSct, 25U), Load(0U, ConfigField::kSrvt, 20U),
    Load(0U, ConfigField::kTransmissionType, 254U),
    Load(0U, ConfigField::kCobId1, 0x0U), Load(0U, ConfigField::kCobId2, 0x0U), Load(0U, ConfigField::kMapCount, 0U),
    Load(0U, ConfigField::kSignature, 0U),
};

// Every field, cut to its width; the neighbours stay.
constexpr Step kWidths[] = {
    Store(1U, ConfigField::kDirection, 0xFFFFFF02U), Load(1U, ConfigField::kDirection, 0x02U),
    Store(1U, ConfigField::kSct, 0x12345678U), Load(1U, ConfigField::kSct, 0x5678U),
    Store(1U, ConfigField::kSrvt, 0x9ABCU), Load(1U, ConfigField::kSrvt, 0xBCU),
    Store(1U, ConfigField::kTransmissionType, 0x1FDU), Load(1U, ConfigField::kTransmissionType, 0xFDU),
    Store(1U, ConfigField::kCobId1, 0xFEDCBA98U), Load(1U, ConfigField::kCobId1, 0xFEDCBA98U),
    Store(1U, ConfigField::kCobId2, 0x76543210U),
    Load(1U, ConfigField::kCobId2, 0x76543210U), Load(1U, ConfigField::kCobId1, 0xFEDCBA98U),
    Store(1U, ConfigField::kMapCount, 0x110U), Load(1U, ConfigField::kMapCount, 0x10U),
    Store(1U, ConfigField::kSignature, 0xABCD1234U), Load(1U, ConfigField::kSignature, 0x1234U),
    Store(0U, ConfigField::kGfcParameter, 0x301U),
    Load(0U, ConfigField::kGfcParameter, 0x01U), Load(1U, ConfigField::kGfcParameter, 0x01U),
    Store(0U, ConfigField::kConfigurationValid, 0x1A5U),
    Load(0U, ConfigField::kConfigurationValid, 0xA5U), Load(1U, ConfigField::kDirection, 0x02U),
    Load(1U, ConfigField::kSct, 0x5678U), Load(1U, ConfigField::kSrvt, 0xBCU),
    Load(0U, ConfigField::kDirection, 0U), Load(0U, ConfigField::kSct, 50U), Load(0U, ConfigField::kSrvt, 20U),
    Load(0U, ConfigField::kTransmissionType, 254U),
    Load(0U, ConfigField::kCobId1, 0x14FU), Load(0U, ConfigField::kCobId2, 0x150U),
    Load(0U, ConfigField::kMapCount, 0U), Load(0U, ConfigField::kSignature, 0U),
};

constexpr Step kEntries[] = {
    Store(0U, ConfigField::kMapEntry, 0x11111101U, 1U), Store(0U, ConfigField::kMapEntry, 0x22222202U, 2U),
    Store(0U, ConfigField::kMapEntry, 0xF0E0D0C0U, 15U),
    Store(0U, ConfigField::kMapEntry, 0xFFFFFFFFU, 16U), Load(0U, ConfigField::kMapEntry, 0x11111101U, 1U),
    Load(0U, ConfigField::kMapEntry, 0x22222202U, 2U),
    Load(0U, ConfigField::kMapEntry, 0U, 3U), Load(0U, ConfigField::kMapEntry, 0xF0E0D0C0U, 15U),
    Load(0U, ConfigField::kMapEntry, 0xFFFFFFFFU, 16U),
    Load(1U, ConfigField::kMapEntry, 0U, 1U),
};

constexpr Step kNowhere[] = {
    Store(0U, ConfigField::kMapEntry, 0x11111101U, 0U), Load(0U, ConfigField::kMapEntry, 0U, 0U),
    Store(0U, ConfigField::kMapEntry, 0x11111101U, 17U),
    Load(0U, ConfigField::kMapEntry, 0U, 17U), Store(0U, ConfigField::kMapEntry, 0x11111101U, 255U),
    Load(0U, ConfigField::kMapEntry, 0U, 255U),
    Store(2U, ConfigField::kDirection, 2U), Load(2U, ConfigField::kDirection, 0U),
    Store(63U, ConfigField::kCobId1, 0x101U), Load(63U, ConfigField::kCobId1, 0U),
    Store(64U, ConfigField::kSct, 7U), Load(64U, ConfigField::kSct, 0U), Store(255U, ConfigField::kSignature, 7U),
    Load(255U, ConfigField::kSignature, 0U),
    Store(2U, ConfigField::kMapEntry, 0x11111101U, 1U), Load(2U, ConfigField::kMapEntry, 0U, 1U),
    Store(0U, ConfigField::kInvalid, 0xFFU), Load(0U, ConfigField::kInvalid, 0U),
    Store(0U, static_cast<ConfigField>(12U), 0xFFU), Load(0U, static_cast<ConfigField>(12U), 0U),
    Store(0U, static_cast<ConfigField>(255U), 0xFFU),
    Load(0U, static_cast<ConfigField>(255U), 0U), Load(0U, ConfigField::kMapEntry, 0U, 1U),
    Load(0U, ConfigField::kMapEntry, 0U, 16U), Load(1U, ConfigField::kMapEntry, 0U, 1U),
    Load(0U, ConfigField::kDirection, 0U), Load(0U, ConfigField::kSct, 50U), Load(0U, ConfigField::kSrvt, 20U),
    Load(0U, ConfigField::kTransmissionType, 254U),
    Load(0U, ConfigField::kCobId1, 0x14FU), Load(0U, ConfigField::kCobId2, 0x150U),
    Load(0U, ConfigField::kMapCount, 0U), Load(0U, ConfigField::kSignature, 0U),
    Load(1U, ConfigField::kDirection, 0U), Load(1U, ConfigField::kSct, 25U), Load(1U, ConfigField::kSrvt, 20U),
    Load(1U, ConfigField::kTransmissionType, 254U),
    Load(1U, ConfigField::kCobId1, 0x0U), Load(1U, ConfigField::kCobId2, 0x0U), Load(1U, ConfigField::kMapCount, 0U),
    Load(1U, ConfigField::kSignature, 0U),
};

// Whatever is stored of one field, the same value included, leaves the SRDO off until it is validated again.
constexpr Step kUnresolvedBySct[] = {
    Configure(), Sct(0U, 50U), Recheck(0U, ConfigFault::kTable, 0x4370U), Cycle(0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Counts(0U, 0U, 1U, 0U), Nmt(NmtState::kStopped), Cycle(1000U),
    Validate(0U, kSound, 0x4370U), Nmt(NmtState::kOperational), Cycle(2000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

constexpr Step kUnresolvedBySrvt[] = {
    Configure(), Srvt(0U, 20U), Recheck(0U, ConfigFault::kTable, 0x4370U), Cycle(0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Counts(0U, 0U, 1U, 0U), Nmt(NmtState::kStopped), Cycle(1000U),
    Validate(0U, kSound, 0x4370U), Nmt(NmtState::kOperational), Cycle(2000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

constexpr Step kUnresolvedByCob1[] = {
    Configure(), CobId1(0U, 0x111U), Recheck(0U, ConfigFault::kTable, 0x4370U), Cycle(0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Counts(0U, 0U, 1U, 0U), Nmt(NmtState::kStopped), Cycle(1000U),
    Validate(0U, kSound, 0x4370U), Nmt(NmtState::kOperational), Cycle(2000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

constexpr Step kUnresolvedByCob2[] = {
    Configure(), CobId2(0U, 0x112U), Recheck(0U, ConfigFault::kTable, 0x4370U), Cycle(0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Counts(0U, 0U, 1U, 0U), Nmt(NmtState::kStopped), Cycle(1000U),
    Validate(0U, kSound, 0x4370U), Nmt(NmtState::kOperational), Cycle(2000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

constexpr Step kUnresolvedByType[] = {
    Configure(), Type(0U, 254U), Recheck(0U, ConfigFault::kTable, 0x4370U), Cycle(0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Counts(0U, 0U, 1U, 0U), Nmt(NmtState::kStopped), Cycle(1000U),
    Validate(0U, kSound, 0x4370U), Nmt(NmtState::kOperational), Cycle(2000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

constexpr Step kUnresolvedByCount[] = {
    Configure(), MapCount(0U, 4U), Recheck(0U, ConfigFault::kTable, 0x4370U), Cycle(0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Counts(0U, 0U, 1U, 0U), Nmt(NmtState::kStopped), Cycle(1000U),
    Validate(0U, kSound, 0x4370U), Nmt(NmtState::kOperational), Cycle(2000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

constexpr Step kUnresolvedByEntry[] = {
    Configure(), Entry(0U, 1U, 0x60100108U), Recheck(0U, ConfigFault::kTable, 0x4370U), Cycle(0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Counts(0U, 0U, 1U, 0U), Nmt(NmtState::kStopped), Cycle(1000U),
    Validate(0U, kSound, 0x4370U), Nmt(NmtState::kOperational), Cycle(2000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

constexpr Step kUnresolvedBehindCount[] = {
    Configure(), Entry(0U, 16U, 0U), Recheck(0U, ConfigFault::kTable, 0x4370U), Cycle(0U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
    Validate(0U, kSound, 0x4370U),
};

constexpr Step kUnresolvedByDirection[] = {
    Configure(), Direction(0U, 2U), Recheck(0U, ConfigFault::kTable, 0x4370U), Cycle(0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Counts(0U, 0U, 1U, 0U), Nmt(NmtState::kStopped), Cycle(1000U),
    Validate(0U, kSound, 0x4370U), Nmt(NmtState::kOperational), Cycle(2000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

// Storing the signature, 1300h or 13FEh resolves and unresolves nothing.
constexpr Step kStillResolved[] = {
    Configure(), Signature(0U, 0x4370U), Store(0U, ConfigField::kGfcParameter, 1U),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), Recheck(0U, kSound, 0x4370U), Cycle(0U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

// What is stored of one slot leaves the other alone.
constexpr Step kOtherSlotStays[] = {
    Configure(), Sct(1U, 50U), Recheck(0U, kSound, 0x4370U), Recheck(1U, ConfigFault::kTable, 0xD999U), Cycle(0U),
    Counts(1U, 0U, 1U, 0U),
};

// A store to a slot that does not exist unresolves nothing.
constexpr Step kStoreNowhereStays[] = {
    Configure(), Store(1U, ConfigField::kSct, 60U), Store(0U, ConfigField::kMapEntry, 1U, 17U),
    Store(0U, ConfigField::kInvalid, 1U), Recheck(0U, kSound, 0x4370U), Cycle(0U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

// Restart forgets whatever was stored, of the last entry as of the first.
constexpr Step kAfterRestart[] = {
    Configure(), Type(0U, 253U), Entry(0U, 16U, 0x12345678U), Store(0U, ConfigField::kGfcParameter, 1U), Restart(),
    Load(0U, ConfigField::kDirection, 0U), Load(0U, ConfigField::kSct, 50U), Load(0U, ConfigField::kSrvt, 20U),
    Load(0U, ConfigField::kTransmissionType, 254U), Load(0U, ConfigField::kCobId1, 0x14FU), Load(0U, ConfigField::kCobId2, 0x150U),
    Load(0U, ConfigField::kMapCount, 0U), Load(0U, ConfigField::kMapEntry, 0U, 1U), Load(0U, ConfigField::kMapEntry, 0U, 2U),
    Load(0U, ConfigField::kMapEntry, 0U, 3U), Load(0U, ConfigField::kMapEntry, 0U, 4U), Load(0U, ConfigField::kMapEntry, 0U, 16U),
    Load(0U, ConfigField::kSignature, 0U), Load(0U, ConfigField::kGfcParameter, 0U), Load(0U, ConfigField::kConfigurationValid, 0U),
};

// 1300h and 13FEh belong to the device: their slot has no meaning.
constexpr Step kOfTheDevice[] = {
    Store(2U, ConfigField::kGfcParameter, 1U), Load(0U, ConfigField::kGfcParameter, 1U), Load(255U, ConfigField::kGfcParameter, 1U),
    Store(255U, ConfigField::kGfcParameter, 0U), Load(1U, ConfigField::kGfcParameter, 0U),
    Store(255U, ConfigField::kConfigurationValid, 0xA5U), Load(0U, ConfigField::kConfigurationValid, 0xA5U),
    Load(64U, ConfigField::kConfigurationValid, 0xA5U), Store(2U, ConfigField::kConfigurationValid, 0U),
    Load(0U, ConfigField::kConfigurationValid, 0U),
};

// Stored while active: active until OPERATIONAL is left, and not again before a Validate.
constexpr Step kWhileActive[] = {
    Configure(), Cycle(0U), Sct(0U, 50U), Cycle(1000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Counts(1U, 0U, 0U, 0U),
    Nmt(NmtState::kStopped), Cycle(2000U), Nmt(NmtState::kOperational), Cycle(3000U),
    Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U), Counts(0U, 0U, 1U, 0U), Nmt(NmtState::kStopped), Cycle(4000U),
    Validate(0U, kSound, 0x4370U), Nmt(NmtState::kOperational), Cycle(5000U), Slot(0U, kWaiting, Cause::kNotOperational, 0U, 1U, 0U),
};

constexpr Step kProducerWhileActive[] = {
    Configure(), Cycle(0U), Srvt(0U, 20U), Cycle(1000U), Slot(0U, kProducing, kNoCause, 0U, 0U, 0U), Counts(0U, 1U, 0U, 0U),
    Nmt(NmtState::kStopped), Cycle(2000U), Nmt(NmtState::kOperational), Request(0U), Cycle(3000U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Counts(0U, 0U, 1U, 0U), Cycle(9000U), Due(0U), NotProducing(0U),
    Nmt(NmtState::kStopped), Cycle(10000U), Validate(0U, kSound, 0xF2B5U), Nmt(NmtState::kOperational), Cycle(11000U),
    Slot(0U, kProducing, kNoCause, 0U, 0U, 0U),
};

constexpr Case kCases[] = {
    MakeCase("DefaultsOfNode1", {req::SRS_CFG_002}, kNode1, kDefaults1),
    MakeCase("DefaultsOfNode32", {req::SRS_CFG_002}, kNode32, kDefaults32),
    MakeCase("DefaultsOfNode33", {req::SRS_CFG_002}, kNode33, kDefaults33),
    MakeCase("DefaultsOfNode64", {req::SRS_CFG_002}, kNode64, kDefaults64),
    MakeCase("DefaultsOfNode65", {req::SRS_CFG_002}, kNode65, kDefaults65),
    MakeCase("DefaultsOfNode127", {req::SRS_CFG_002}, kNode127, kDefaults127),
    MakeCase("DefaultsOfNumber2", {req::SRS_CFG_002}, kSecondOnly, kDefaultsOfNumber2),
    MakeCase("FieldsAreCutToTheirWidth", {req::SRS_CFG_003}, kBareTwo, kWidths),
    MakeCase("MapEntriesAreKept", {req::SRS_CFG_003}, kBareTwo, kEntries),
    MakeCase("AddressesThatDoNotExist", {req::SRS_CFG_003}, kBareTwo, kNowhere),
    MakeCase("StoreUnresolvesSct", {req::SRS_CFG_003, req::SRS_CFG_030}, kGold, kUnresolvedBySct),
    MakeCase("StoreUnresolvesSrvt", {req::SRS_CFG_003, req::SRS_CFG_030}, kGold, kUnresolvedBySrvt),
    MakeCase("StoreUnresolvesCob1", {req::SRS_CFG_003, req::SRS_CFG_030}, kGold, kUnresolvedByCob1),
    MakeCase("StoreUnresolvesCob2", {req::SRS_CFG_003, req::SRS_CFG_030}, kGold, kUnresolvedByCob2),
    MakeCase("StoreUnresolvesType", {req::SRS_CFG_003, req::SRS_CFG_030}, kGold, kUnresolvedByType),
    MakeCase("StoreUnresolvesCount", {req::SRS_CFG_003, req::SRS_CFG_030}, kGold, kUnresolvedByCount),
    MakeCase("StoreUnresolvesEntry", {req::SRS_CFG_003, req::SRS_CFG_030}, kGold, kUnresolvedByEntry),
    MakeCase("StoreUnresolvesBehindTheCount", {req::SRS_CFG_003, req::SRS_CFG_030}, kGold, kUnresolvedBehindCount),
    MakeCase("StoreUnresolvesDirection", {req::SRS_CFG_003, req::SRS_CFG_030}, kGold, kUnresolvedByDirection),
    MakeCase("SignatureIsStoredWithoutUnresolving", {req::SRS_CFG_003, req::SRS_CFG_030}, kGold, kStillResolved),
    MakeCase("StoreOfOneSlotLeavesTheOther", {req::SRS_CFG_003, req::SRS_CFG_030}, kTwo, kOtherSlotStays),
    MakeCase("StoreWithoutAnAddressLeavesEverything", {req::SRS_CFG_003}, kGold, kStoreNowhereStays),
    MakeCase("RestartForgetsWhatWasStored", {req::SRS_CFG_002}, kGold, kAfterRestart),
    MakeCase("ObjectsOfTheDeviceHaveNoSlot", {req::SRS_CFG_003}, kBareTwo, kOfTheDevice),
    MakeCase("StoreWhileActive", {req::SRS_CFG_003, req::SRS_CONS_002}, kGold, kWhileActive),
    MakeCase("StoreWhileProducing", {req::SRS_CFG_003, req::SRS_CONS_002}, kSender, kProducerWhileActive),
};
// clang-format on
} // namespace

const CaseTable kStoreCases = MakeTable("store", kCases);

} // namespace counterpoint::conformance
