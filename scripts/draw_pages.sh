#!/usr/bin/env bash
# Draws the pictures of pages in the manuals: runs dsc and the first session of the Python manual, and
# opens their pages in Chromium.
# Usage: scripts/draw_pages.sh [BUILD_DIR]
. "$(dirname "$0")/figures.sh"
require "$build/dsc"
begin_in_temporary_folder

# picture PAGE PICTURE COMMANDS: opens the page, executes commands of `viewer`, and saves a picture.
picture() {
  local commands="<script>addEventListener('load', async () => { await viewer.ready; $3 });</script>"
  sed "s|</body>|$commands</body>|" "$1" >shown.html
  chromium --headless=new --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader \
    --hide-scrollbars --window-size=1200,800 --virtual-time-budget=30000 --user-data-dir="$work/profile" \
    --screenshot="$2" "file://$work/shown.html" >/dev/null 2>&1
  [ -s "$2" ]
}

tar --extract --gzip --file "$data" --strip-components=2 \
  data/meshes/bunny00.off
"$build/dsc" offset bunny00.off --triangles 14000 --distance=-.25e --steps 10 --output bunny --quiet
"$build/dsc" view bunny -o bunny.html --quiet
picture bunny.html "$source/doc/Dsc_program/fig/view_bunny.png" \
  "viewer.setUp(1); await viewer.showFrame(4); viewer.setCut({mode: 'cells', axis: 2, position: null, flip: false}); viewer.setWireframe(true);"

"$build/dsc" fluid collision --steps 40 --every 4 --output fluid --report fluid.json --quiet
"$build/dsc" view fluid -o fluid.html --report fluid.json --without 0 --quiet
picture fluid.html "$source/doc/Dsc_program/fig/view_fluid.png" \
  "await viewer.showFrame(6); viewer.setColor('velocity');"

"$build/dsc" zalesak --steps 40 --every 4 --output plane --report plane.json --quiet
"$build/dsc" view plane -o plane.html --report plane.json --quiet
picture plane.html "$source/doc/Dsc_program/fig/view_plane.png" \
  "await viewer.showFrame(3); viewer.setLabels([0, 1]); viewer.setWireframe(true);"

PYTHONPATH="$build/python" "$python" "$source/test/python/example.py" two_balls.html
picture two_balls.html "$source/doc/Python_module/fig/two_balls.png" "await viewer.showFrame(15);"
