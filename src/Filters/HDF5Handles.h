/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef HDF5Handles_h
#define HDF5Handles_h

#include "itk_hdf5.h"

namespace tissue
{
/** HDF5 says on standard error what goes wrong, as long as it is let. */
class HDF5Silence
{
public:
  HDF5Silence()
  {
    H5Eget_auto2(H5E_DEFAULT, &m_Function, &m_Data);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~HDF5Silence() { H5Eset_auto2(H5E_DEFAULT, m_Function, m_Data); }
  HDF5Silence(const HDF5Silence &) = delete;
  HDF5Silence &
  operator=(const HDF5Silence &) = delete;

private:
  H5E_auto2_t m_Function = nullptr;
  void *      m_Data = nullptr;
};

/** An object of HDF5, closed in the end. */
class HDF5Identifier
{
public:
  HDF5Identifier(hid_t id, herr_t (*close)(hid_t))
    : m_Id(id)
    , m_Close(close)
  {}
  ~HDF5Identifier()
  {
    if (m_Id >= 0)
    {
      m_Close(m_Id);
    }
  }
  HDF5Identifier(const HDF5Identifier &) = delete;
  HDF5Identifier &
  operator=(const HDF5Identifier &) = delete;

  operator hid_t() const { return m_Id; }

private:
  hid_t m_Id;
  herr_t (*m_Close)(hid_t);
};
} // namespace tissue

#endif
