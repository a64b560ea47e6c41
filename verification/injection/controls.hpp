// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_CONTROLS_HPP
#define VERIFICATION_INJECTION_CONTROLS_HPP

#include "verification/injection/campaign.hpp"
#include "verification/injection/space.hpp"

#include <vector>

namespace counterpoint::injection
{

/// A danger that is planted, and how it has to be told.
struct Control
{
    std::string name;
    Class expected;
    std::string what; ///< Empty: whatever.
    Verdict told;

    [[nodiscard]] bool IsGood() const
    {
        return (told.kind == expected) && (what.empty() || (what == told.what));
    }
};

/// @brief Plants each kind of what is dangerous, and what is not. [SRS_VER_042]
[[nodiscard]] std::vector<Control> RunControls(Campaign& campaign, const Space& space,
                                               const std::vector<ScriptStep>& script);

} // namespace counterpoint::injection

#endif
