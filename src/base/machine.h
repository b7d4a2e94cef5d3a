/* What this machine has for a run: memory and processors. */
#ifndef BASE_MACHINE_H
#define BASE_MACHINE_H

/* Bytes that this process may fill: the least of physical memory, the limits of its control groups,
 * and its address space limit. *what says which. 0 when unknown. */
double machine_memory(const char **what);

#endif
