/* Prints the devices that --backend cuda:N chooses from. */
#include "tools/devices.h"

#include "device/device.h"
#include "render/egl_devices.h"

#include <stdio.h>

#if HAVE_CUDA

/* "12.8" of 12080. */
static void print_version(const char *what, int version)
{
    printf("%s %d.%d", what, version / 1000, version % 1000 / 10);
}

static void print_device(int number)
{
    struct device_info info;
    struct error e = {0};
    int egl = egl_device_of_cuda(number);
    if (device_cuda.info(number, &info, &e)) {
        printf("  cuda:%d  %s\n", number, e.text);
        return;
    }
    printf("  cuda:%d  %s, compute capability %d.%d, %.1f GB, %.1f GB free, ", number, info.name,
           info.compute / 10, info.compute % 10, 1e-9 * (double)info.memory,
           1e-9 * (double)info.free);
    print_version("driver for CUDA", info.driver);
    print_version(", runtime", info.runtime);
    if (egl < 0)
        printf(", no OpenGL of its own\n");
    else
        printf(", OpenGL by EGL device %d\n", egl);
}

void devices_print(void)
{
    const char *why;
    int count = device_cuda.count(&why);
    printf("devices: GPUs for --backend cuda:N\n");
    for (int number = 0; number < count; number++)
        print_device(number);
    if (count == 0)
        printf("  none%s%s\n", *why ? ": " : "", why);
}

#else

void devices_print(void)
{
    printf("devices: GPUs for --backend cuda:N\n  none: this build has no CUDA\n");
}

#endif
