// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Signature vectors. GOLD is published by a manufacturer; the others follow from the layout, computed outside this
// program.
#include "verification/conformance/gold.hpp"
#include "verification/conformance/stores.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr ConfigFault kSound = ConfigFault::kNone;


constexpr Step kGoldVector[] = {
    Direction(0U, 2U), Sct(0U, 50U), Srvt(0U, 20U), CobId1(0U, 0x111U), CobId2(0U, 0x112U), Entry(0U, 1U, 0x60100108U),
    Entry(0U, 2U, 0x60110108U),
    Entry(0U, 3U, 0x60100208U), Entry(0U, 4U, 0x60110208U), MapCount(0U, 4U), Signature(0U, 0x4370U),
    Validate(0U, kSound, 0x4370U), Recheck(0U, kSound, 0x4370U),
};

constexpr Step kVectorA[] = {
    Direction(0U, 1U), Sct(0U, 25U), Srvt(0U, 20U), CobId1(0U, 0x101U), CobId2(0U, 0x102U), Entry(0U, 1U, 0x20000008U),
    Entry(0U, 2U, 0x20010008U), MapCount(0U, 2U),
    Validate(0U, ConfigFault::kSignature, 0x4B2DU), Signature(0U, 0x4B2DU), Validate(0U, kSound, 0x4B2DU),
    Recheck(0U, kSound, 0x4B2DU),
};

constexpr Step kVectorB[] = {
    Direction(0U, 2U), Sct(0U, 50U), Srvt(0U, 20U), CobId1(0U, 0x103U), CobId2(0U, 0x104U), Entry(0U, 1U, 0x62000120U),
    Entry(0U, 2U, 0x62010120U), MapCount(0U, 2U),
    Signature(0U, 0xD999U), Validate(0U, kSound, 0xD999U), Recheck(0U, kSound, 0xD999U),
};

constexpr Step kVectorC[] = {
    Direction(0U, 1U), Sct(0U, 10U), Srvt(0U, 5U), CobId1(0U, 0x17FU), CobId2(0U, 0x180U), Entry(0U, 1U, 0x66210108U),
    Entry(0U, 2U, 0x66230108U),
    Entry(0U, 3U, 0x66210208U), Entry(0U, 4U, 0x66230208U), Entry(0U, 5U, 0x66210308U), Entry(0U, 6U, 0x66230308U),
    Entry(0U, 7U, 0x66210408U),
    Entry(0U, 8U, 0x66230408U), Entry(0U, 9U, 0x66210508U), Entry(0U, 10U, 0x66230508U), Entry(0U, 11U, 0x66210608U),
    Entry(0U, 12U, 0x66230608U),
    Entry(0U, 13U, 0x66210708U), Entry(0U, 14U, 0x66230708U), Entry(0U, 15U, 0x66210808U), Entry(0U, 16U, 0x66230808U),
    MapCount(0U, 16U),
    Signature(0U, 0xB825U), Validate(0U, kSound, 0xB825U), Recheck(0U, kSound, 0xB825U),
};

constexpr Step kVectorD[] = {
    Direction(0U, 1U), Sct(0U, 25U), Srvt(0U, 20U), CobId1(0U, 0x101U), CobId2(0U, 0x102U), Signature(0U, 0xCD8AU),
    Validate(0U, ConfigFault::kMapping, 0xCD8AU),
    Recheck(0U, ConfigFault::kTable, 0xCD8AU),
};

constexpr Step kVectorE[] = {
    Direction(0U, 1U), Sct(0U, 25U), Srvt(0U, 20U), CobId1(0U, 0x101U), CobId2(0U, 0x102U), Entry(0U, 1U, 0x62100108U),
    Entry(0U, 2U, 0x62110108U),
    Entry(0U, 3U, 0x62100208U), Entry(0U, 4U, 0x62110208U), MapCount(0U, 4U), Signature(0U, 0xF2B5U),
    Validate(0U, kSound, 0xF2B5U), Recheck(0U, kSound, 0xF2B5U),
};

constexpr Step kVectorF[] = {
    Direction(0U, 0U), Sct(0U, 25U), Srvt(0U, 20U), CobId1(0U, 0x101U), CobId2(0U, 0x102U),
    Validate(0U, ConfigFault::kSignature, 0x88E9U), Signature(0U, 0x88E9U),
    Validate(0U, kSound, 0x88E9U), Recheck(0U, kSound, 0x88E9U),
};

// Values that other byte orders and start values give for GOLD.
constexpr Step kGoldNegative[] = {
    StoreAll(), Signature(0U, 0x98A7U), Validate(0U, ConfigFault::kSignature, 0x4370U), Signature(0U, 0xF04EU),
    Validate(0U, ConfigFault::kSignature, 0x4370U),
    Signature(0U, 0xDFB3U), Validate(0U, ConfigFault::kSignature, 0x4370U), Signature(0U, 0x7043U),
    Validate(0U, ConfigFault::kSignature, 0x4370U), Signature(0U, 0x4371U),
    Validate(0U, ConfigFault::kSignature, 0x4370U), Signature(0U, 0xC370U),
    Validate(0U, ConfigFault::kSignature, 0x4370U), Signature(0U, 0x0000U),
    Validate(0U, ConfigFault::kSignature, 0x4370U), Signature(0U, 0x4370U), Validate(0U, kSound, 0x4370U),
};

// What is covered changes the signature; transmission type, 1300h and 13FEh do not.
constexpr Step kCovered[] = {
    StoreAll(), Sct(0U, 51U), Validate(0U, ConfigFault::kSignature, 0x1A36U), Sct(0U, 0x132U),
    Validate(0U, ConfigFault::kSignature, 0xCD59U), Sct(0U, 50U),
    Srvt(0U, 21U), Validate(0U, ConfigFault::kSignature, 0x4A6FU), Srvt(0U, 20U), CobId1(0U, 0x113U),
    CobId2(0U, 0x114U),
    Validate(0U, ConfigFault::kSignature, 0x3F04U), CobId1(0U, 0x111U), CobId2(0U, 0x112U), MapCount(0U, 2U),
    Validate(0U, ConfigFault::kSignature, 0x7EBEU), MapCount(0U, 4U), Entry(0U, 3U, 0x60110208U),
    Entry(0U, 4U, 0x60100208U),
    Validate(0U, ConfigFault::kSignature, 0xC820U), Entry(0U, 3U, 0x60100208U), Entry(0U, 4U, 0x60110208U),
    Direction(0U, 0U),
    Validate(0U, ConfigFault::kSignature, 0x48E9U), Direction(0U, 2U), Store(0U, ConfigField::kGfcParameter, 1U),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U),
    Entry(0U, 5U, 0x12345678U), Entry(0U, 16U, 0x12345678U), Validate(0U, kSound, 0x4370U),
};

// Reserved bits of the identifiers are part of what is signed.
constexpr Step kAllBytes[] = {
    StoreAll(), CobId1(0U, 0x84030111U), CobId2(0U, 0x84030112U), Validate(0U, ConfigFault::kIdentifier, 0x5566U),
    Direction(0U, 0U), Signature(0U, 0x5EFFU), Validate(0U, kSound, 0x5EFFU),
};

constexpr Step kCountAboveSixteen[] = {
    StoreAll(), MapCount(0U, 17U), Validate(0U, ConfigFault::kMapping, 0x72C4U),
    Recheck(0U, ConfigFault::kTable, 0x72C4U), MapCount(0U, 255U),
    Validate(0U, ConfigFault::kMapping, 0x72C4U), Direction(0U, 0U), Validate(0U, ConfigFault::kSignature, 0xDBFFU),
};

constexpr Case kCases[] = {
    MakeCase("VectorGold", {req::SRS_CFG_010, req::SRS_CFG_029}, kBare, kGoldVector),
    MakeCase("VectorA", {req::SRS_CFG_010, req::SRS_CFG_029}, kBare, kVectorA),
    MakeCase("VectorB", {req::SRS_CFG_010, req::SRS_CFG_029}, kBare, kVectorB),
    MakeCase("VectorC", {req::SRS_CFG_010, req::SRS_CFG_028}, kBare, kVectorC),
    MakeCase("VectorD", {req::SRS_CFG_010, req::SRS_CFG_026, req::SRS_CFG_020}, kBare, kVectorD),
    MakeCase("VectorE", {req::SRS_CFG_010, req::SRS_CFG_029}, kBare, kVectorE),
    MakeCase("VectorF", {req::SRS_CFG_010, req::SRS_CFG_020}, kBare, kVectorF),
    MakeCase("NegativeVectorsOfGold", {req::SRS_CFG_010, req::SRS_CFG_029}, kGold, kGoldNegative),
    MakeCase("WhatTheSignatureCovers", {req::SRS_CFG_010}, kGold, kCovered),
    MakeCase("SignatureCoversAllBytesOfAnIdentifier", {req::SRS_CFG_010, req::SRS_CFG_023}, kGold, kAllBytes),
    MakeCase("MapCountAboveSixteenIsSignedAsSixteen", {req::SRS_CFG_020, req::SRS_CFG_010, req::SRS_CFG_026}, kWide,
             kCountAboveSixteen),
};
// clang-format on
} // namespace

const CaseTable kSignatureCases = MakeTable("signature", kCases);

} // namespace counterpoint::conformance
