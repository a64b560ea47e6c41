// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TRACE_VERIFIES_HPP
#define VERIFICATION_TRACE_VERIFIES_HPP

#include "verification/trace/requirement_id.hpp"

#include <gtest/gtest.h>

#include <string>

namespace counterpoint
{
/// Records in the XML report that the running test verifies `requirement`; the trace gate reads it from there.
/// May be called several times in one test: each call gets a property of its own (requirement-1, requirement-2, ...).
inline void Verifies(const req::RequirementId requirement)
{
    const ::testing::TestInfo* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    const int recorded = (test == nullptr) ? 0 : test->result()->test_property_count();
    ::testing::Test::RecordProperty("requirement-" + std::to_string(recorded + 1), requirement.text);
}
} // namespace counterpoint

#endif
