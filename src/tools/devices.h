/* The GPUs of this machine. */
#ifndef TOOLS_DEVICES_H
#define TOOLS_DEVICES_H

/* Prints them, or why there are none. */
void devices_print(void);

#endif
