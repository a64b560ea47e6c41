// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/manager/scenes.hpp"

extern "C" std::uint32_t TargetMain() noexcept;

extern "C" std::uint32_t TargetMain() noexcept
{
    return counterpoint::target::PlayScenes();
}
