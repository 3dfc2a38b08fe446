/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkPointSetToTissueLabelImageFilter_h
#define itkPointSetToTissueLabelImageFilter_h

#include "TissueTessellationCore/Points/TissueGrid.h"
#include "itkImageBase.h"
#include "itkImageSource.h"
#include "itkPointSet.h"
#include "itkPointTissueEnums.h"
#include "itkTissueVotes.h"

#include <limits>

namespace itk
{
/** \class PointSetToTissueLabelImageFilter
 * \brief Makes the label image of a tissue from the centres of its cells alone.
 *
 * Input: a point set of at least four cell centres in physical space, such as those of nuclei. Output: a 3-D label
 * image, for the filters that take segmented images. Its label is i + 1 for the cell of the i-th point in the order of
 * the container, and 0 for the exterior; every point has a cell. Second output: the votes on which cells meet
 * (GetVotes()), for the filters that make walls of the image; there are none for a layer of cells.
 *
 * Where the points lie in one layer, flat or curved, the tissue is that layer, as thick as its cells are wide, and what
 * a shell encloses is exterior; SetLayer() decides where the points leave it open. Otherwise
 * the tissue is the inside of the points' Delaunay tetrahedralization, cleaned of surface triangles that are too large
 * for the local spacing, and a margin. In it the cells are the anisotropic tessellation that has its cells' centroids
 * on the points: that centres are centroids tells more of the cells' sizes and shapes than the points' Voronoi cells
 * do. The margin is fitted jointly with the cells. How exact the points are is estimated: where they cannot be the
 * centroids of a tissue, the cells are nearly Voronoi cells except for the shape that neighbours have in common.
 *
 * The box that the points were seen in is that of the reference image, if there is one. It is filled by the image's
 * whole voxels, and cells at its sides are cut by them. Otherwise it is the points' bounding box, padded. The output
 * fills the box with nearly cubic voxels along the box's direction, about VoxelsPerCell to a cell. It is the same for
 * any number of threads.
 *
 * Progress is that of the whole; the filter can be aborted. Errors (ExceptionObject): fewer than four points, two at
 * the same place, one that is not finite or outside of the box, all in one plane while Layer is Off; more points than
 * the pixel type has labels.
 *
 * \sa LabelImageToCellWallMeshFilter
 * \ingroup TissueTessellation */
template <typename TPointSet, typename TLabelImage>
class ITK_TEMPLATE_EXPORT PointSetToTissueLabelImageFilter : public ImageSource<TLabelImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PointSetToTissueLabelImageFilter);

  using Self = PointSetToTissueLabelImageFilter;
  using Superclass = ImageSource<TLabelImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using PointSetType = TPointSet;
  using LabelImageType = TLabelImage;
  using LabelPixelType = typename LabelImageType::PixelType;
  using ReferenceImageType = ImageBase<3>;
  using LayerEnum = PointTissueEnums::Layer;

  static_assert(TPointSet::PointDimension == 3 && TLabelImage::ImageDimension == 3, "A tissue has three dimensions.");
  static_assert(std::numeric_limits<LabelPixelType>::is_integer, "Labels are integers.");

  itkNewMacro(Self);
  itkTypeMacro(PointSetToTissueLabelImageFilter, ImageSource);

  using Superclass::SetInput;
  void
  SetInput(const PointSetType * points);
  const PointSetType *
  GetInput() const;

  /** The image that the points were found in, which is optional. It gives the box that it fills; its voxels are not
   * read.
   */
  itkSetInputMacro(ReferenceImage, ReferenceImageType);
  itkGetInputMacro(ReferenceImage, ReferenceImageType);

  /** About how many voxels of the output the mean cell has, at least 50. The fit takes no more than 700. The default is
   * 4000. */
  itkSetMacro(VoxelsPerCell, double);
  itkGetConstMacro(VoxelsPerCell, double);

  /** Whether the tissue is taken for one layer of cells. The default is Automatic. */
  itkSetEnumMacro(Layer, LayerEnum);
  itkGetEnumMacro(Layer, LayerEnum);

  /** The second output, by name ("Votes"), as it is beside the image that the filter is for. */
  TissueVotes *
  GetVotes();
  const TissueVotes *
  GetVotes() const;

  using Superclass::MakeOutput;
  ProcessObject::DataObjectPointer
  MakeOutput(const ProcessObject::DataObjectIdentifierType & name) override;

protected:
  PointSetToTissueLabelImageFilter();
  ~PointSetToTissueLabelImageFilter() override = default;

  /** Updates the input first, as the output's size depends on the points. */
  void
  GenerateOutputInformation() override;

  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  /** Gives the points along the axes of the box, from its corner; without a reference image they are physical. */
  std::vector<tissue::Point>
  MakePoints() const;

  /** Throws where a point is outside of the box, and names the first that is, in physical coordinates. */
  void
  RefusePointsOutside(const std::vector<tissue::Point> & points, const tissue::Box & box) const;

  tissue::TissueGrid m_Grid;
  double             m_VoxelsPerCell{ 4000.0 };
  LayerEnum          m_Layer{ LayerEnum::Automatic };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkPointSetToTissueLabelImageFilter.hxx"
#endif

#endif
