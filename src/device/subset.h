/* What .cu files include before headers in the common subset of C and CUDA: the standard headers those
 * use, after which `inline` makes functions for the device. #undef inline ends that. */
#ifndef DEVICE_SUBSET_H
#define DEVICE_SUBSET_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define inline __device__ __inline__

#endif
