// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWINS_SUBJECT_HPP
#define VERIFICATION_TWINS_SUBJECT_HPP

#include "safety_core/contract/channel.hpp"

/// The channel of a library, with storage for all SRDOs and entries. What the program looks up in each library.
extern "C" counterpoint::Channel* CounterpointSubject();

#endif
