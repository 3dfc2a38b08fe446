set(DOCUMENTATION
  "Topologically accurate triangular meshes of all cell walls of a living tissue,
from a segmented 3-D image: an adjacency complex of the cells is
optimized by local topological operations and dualized.")

# Applications, benchmarks and tests need VTK as well; the filters do not.
itk_module(TissueTessellation
  DEPENDS
    ITKCommon
    ITKConnectedComponents
    ITKDistanceMap
    ITKHDF5
    ITKIOImageBase
    ITKImageGrid
    ITKImageIntensity
    ITKImageNoise
    ITKImageSources
    ITKLabelMap
    ITKMathematicalMorphology
    ITKSmoothing
    ITKThresholding
    ITKWatersheds
    ITKZLIB
  TEST_DEPENDS
    ITKTestKernel
    ITKGoogleTest
    ITKImageStatistics
    ITKIOTIFF
  DESCRIPTION "${DOCUMENTATION}"
  EXCLUDE_FROM_DEFAULT
  ENABLE_SHARED
)
