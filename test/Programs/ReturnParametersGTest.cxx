/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/ReturnParameters.h"

#include "RefusalOf.h"
#include "TemporaryFolder.h"

using ReturnParametersFile = TemporaryFolderTest;

TEST_F(ReturnParametersFile, HasALineForEachNumber)
{
  tissue::WriteReturnParameters({ { "cells", 1000000.0 }, { "error", 0.1 }, { "none", 3e-17 } },
                                this->PathOf("results"));
  EXPECT_EQ(ReadBytes(this->PathOf("results")), "cells = 1000000\nerror = 0.1\nnone = 0\n");
  EXPECT_NE(RefusalOf([&] { tissue::WriteReturnParameters({}, this->PathOf("none/results")); }), "");
}
