// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TRACE_REQUIREMENT_ID_HPP
#define VERIFICATION_TRACE_REQUIREMENT_ID_HPP

namespace counterpoint::req
{
/// Names one requirement; only the headers in ids/ make one, so that an unknown or retired identifier does not compile.
struct RequirementId
{
    const char* text;
};
} // namespace counterpoint::req

#endif
