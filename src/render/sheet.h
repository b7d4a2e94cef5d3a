/* A contact sheet: pictures of one size in rows on one image, the time under each. */
#ifndef RENDER_SHEET_H
#define RENDER_SHEET_H

#include "base/error.h"
#include "base/image.h"
#include "render/render.h"

struct sheet;

/* Pixels of a sheet of `cells` columns and rows of pictures of movie.size. */
void sheet_size(const struct scene *scene, const int cells[2], int size[2]);

/* An empty sheet; STATUS_RUN when memory is short. The setup need not outlive the call. */
enum status sheet_open(struct sheet **sheet, const struct render_setup *setup, const int cells[2],
                       struct error *e);

/* Puts a picture of movie.size into the next cell, by rows; beyond the last it is left out. Takes what is
 * over it as lines and text, if any. */
void sheet_add(struct sheet *sheet, double time, struct image *picture);

const struct image *sheet_image(const struct sheet *sheet);
void sheet_close(struct sheet *sheet); /* accepts NULL */

#endif
