// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_CASES_HPP
#define VERIFICATION_CONFORMANCE_CASES_HPP

#include "verification/conformance/case.hpp"

namespace counterpoint::conformance
{

extern const CaseTable kTimeCases;
extern const CaseTable kFrameCases;
extern const CaseTable kFaultCases;
extern const CaseTable kCycleCases;
extern const CaseTable kSignalCases;
extern const CaseTable kActivityCases;
extern const CaseTable kReleaseCases;
extern const CaseTable kAcknowledgeCases;
extern const CaseTable kCommitCases;
extern const CaseTable kPermitCases;
extern const CaseTable kDefectCases;
extern const CaseTable kProducerCases;
extern const CaseTable kConfirmationCases;
extern const CaseTable kRefreshCases;
extern const CaseTable kSignatureCases;
extern const CaseTable kStoreCases;
extern const CaseTable kRuleCases;
extern const CaseTable kMappingCases;
extern const CaseTable kSharedCases;
extern const CaseTable kRecheckCases;
extern const CaseTable kSizeCases;
extern const CaseTable kSideCases;
extern const CaseTable kLateCases;
extern const CaseTable kBitCases;
extern const CaseTable kEntryCases;
extern const CaseTable kDummyCases;
extern const CaseTable kStaticCases;
extern const CaseTable kDigestCases;

/// In the order in which they run: simple ones first.
extern const CaseTable* const kAllTables[];
extern const std::uint32_t kTableCount;

} // namespace counterpoint::conformance

#endif
