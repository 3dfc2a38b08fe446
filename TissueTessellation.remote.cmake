# For the folder Modules/Remote of ITK's sources: Module_TissueTessellation=ON then clones this module into the build.
# CGAL, Eigen, libtiff and Expat must be installed. TissueTessellation_GIT_REPOSITORY is where to clone from.
set(TissueTessellation_GIT_REPOSITORY "" CACHE STRING "Git repository of the remote module TissueTessellation")
set(TissueTessellation_GIT_TAG "main" CACHE STRING "Its branch, tag or commit")
mark_as_advanced(TissueTessellation_GIT_REPOSITORY TissueTessellation_GIT_TAG)
itk_fetch_module(TissueTessellation
  "Topologically accurate triangular meshes of all cell walls of a living tissue, from a 3-D image of its segmented cells,
nuclei or membranes, after Cerutti et al., 3DV 2015, https://doi.org/10.1109/3DV.2015.57"
  MODULE_COMPLIANCE_LEVEL 2
  GIT_REPOSITORY "${TissueTessellation_GIT_REPOSITORY}"
  GIT_TAG "${TissueTessellation_GIT_TAG}"
)
