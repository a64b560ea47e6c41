// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/nmt_master.hpp"

#include <gtest/gtest.h>
