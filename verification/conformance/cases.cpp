// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/conformance/cases.hpp"

namespace counterpoint::conformance
{

const CaseTable* const kAllTables[] = {
    &kSignatureCases,    &kStoreCases,       &kRuleCases,   &kMappingCases, &kSharedCases, &kRecheckCases,
    &kFrameCases,        &kFaultCases,       &kTimeCases,   &kCycleCases,   &kSignalCases, &kActivityCases,
    &kReleaseCases,      &kAcknowledgeCases, &kCommitCases, &kPermitCases,  &kDefectCases, &kProducerCases,
    &kConfirmationCases, &kRefreshCases,     &kSizeCases,   &kSideCases,    &kLateCases,   &kBitCases,
    &kEntryCases,        &kDummyCases,       &kStaticCases, &kDigestCases,
};
const std::uint32_t kTableCount = sizeof(kAllTables) / sizeof(kAllTables[0]);

} // namespace counterpoint::conformance
