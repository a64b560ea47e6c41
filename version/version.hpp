// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERSION_VERSION_HPP
#define VERSION_VERSION_HPP

/// "counterpoint 0.1.0 (commit 0123456789ab, objects 0123456789abcdef)": the commit is "unknown" where the sources are
/// no repository; the objects are those of core and channels in this build, by the first digits of their SHA-256
/// (version/digest.py). It has one name in every program, so that a tool finds it in an image. [SRS_CLI_024,
/// SRS_FW_021]
extern "C" const char CounterpointVersion[];

#endif
