/* Kernels of frames: FRAME(name, what it works on). Included again and again. */
FRAME(show, struct shown)
FRAME(hash, struct hash_work)
