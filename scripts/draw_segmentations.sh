#!/usr/bin/env bash
# Segments images and draws the pictures of the manual: doc/Image_segmentation/fig/segmentation_NAME.png.
# Needs the targets dsc, dsc-files and dsc-segment in BUILD_DIR.
# Usage: scripts/draw_segmentations.sh [BUILD_DIR]
. "$(dirname "$0")/figures.sh"
fig=$source/doc/Image_segmentation/fig

"$source/scripts/install_dependencies.sh" libvtk9-dev mricron-data python3-skimage
require "$build"/{dsc,dsc-files,dsc-segment}
begin_in "$build/segmentations"
photographs=$("$python" -c 'import os, skimage.data; print(os.path.dirname(skimage.data.__file__))')

shrink() { # PICTURE NAME
  "$python" - "$1" "$fig/segmentation_$2.png" <<'SHRINK'
import sys
from skimage import io, transform, util

picture = io.imread(sys.argv[1])[:, :, :3]
rows, columns = ((picture != 255).any(axis=2).any(axis=k).nonzero()[0] for k in (1, 0))
picture = picture[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1]
shape = [round(480 * n / max(picture.shape[:2])) for n in picture.shape[:2]]
io.imsave(sys.argv[2], util.img_as_ubyte(transform.resize(picture, shape, anti_aliasing=True)))
SHRINK
}

"$python" - "$source/benchmark" <<'PHANTOM'
import sys
sys.path.insert(0, sys.argv[1])
import segmentation
segmentation.write_mha("phantom.mha", segmentation.phantom(2, 512, .25, 22)[0])
PHANTOM
"$build/dsc" segment phantom.mha --phases 4 --picture phantom.png
shrink phantom.png phantom
"$build/dsc" segment "$photographs/astronaut.png" --color --phases 5 --picture astronaut.png
shrink astronaut.png astronaut
"$build/dsc" segment /usr/share/mricron/templates/ch2bet.nii.gz --phases 4 --output brain.vtu
"${display[@]}" "$python" "$source/scripts/render_phases.py" brain.vtu brain.png
shrink brain.png brain
