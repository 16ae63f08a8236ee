#pragma once

// What is used of OpenCV's calib3d. Its header comes in a package that wants 230 others (Qt, GDAL,
// 430 MB); with the library alone, the four functions of OpenCV 4.6 are declared here.
#ifdef SCANFUSE_CALIB3D_HEADER
#include <opencv2/calib3d.hpp>
#else
#include <opencv2/core.hpp>

namespace cv {

enum Calib3dFlags {
  CALIB_CB_ADAPTIVE_THRESH = 1,
  CALIB_CB_NORMALIZE_IMAGE = 2,
  CALIB_CB_ACCURACY = 32,
  CALIB_CB_LARGER = 64,
  CALIB_ZERO_TANGENT_DIST = 8,
  CALIB_FIX_K1 = 32,
  CALIB_FIX_K2 = 64,
  CALIB_FIX_K3 = 128
};

bool findChessboardCorners(InputArray image, Size pattern, OutputArray corners, int flags);
bool findChessboardCornersSB(InputArray image, Size pattern, OutputArray corners, int flags,
                             OutputArray meta);
double calibrateCamera(InputArrayOfArrays object_points, InputArrayOfArrays image_points,
                       Size image_size, InputOutputArray camera_matrix, InputOutputArray distortion,
                       OutputArrayOfArrays rotations, OutputArrayOfArrays translations,
                       OutputArray deviations_intrinsics, OutputArray deviations_extrinsics,
                       OutputArray errors_per_view, int flags, TermCriteria criteria);
void projectPoints(InputArray object_points, InputArray rotation, InputArray translation,
                   InputArray camera_matrix, InputArray distortion, OutputArray image_points,
                   OutputArray jacobian, double aspect_ratio);

}  // namespace cv
#endif
