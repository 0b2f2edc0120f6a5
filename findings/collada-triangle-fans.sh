#!/bin/bash
# What one would guess: a COLLADA list of triangle fans (<trifans>) is read as the triangles that share its first corner, as
# <tristrips> and <triangles> are.
# What it is: Assimp reads a fan as one polygon with all its corners, also where they lie in no plane. Of a cone of four sides, apex
# first, it makes one face of six corners, without a word; triangulated (-tri) it keeps an area of 2 of 6. Strips and triangles of the
# same cone are read right.
# Version: assimp-utils 5.2.5~ds0-1+b1 (Debian 12). Source: Khronos Group, "COLLADA - Digital Asset Schema Release 1.4.1",
# elements trifans, tristrips and triangles; the behaviour printed below.
# Why it matters here: a nose cone that is written as a fan loses most of its area, and with it its intensity, with no error. Our
# reader gives Assimp the triangles of fans.
set -euo pipefail

assimp='5.2.5~ds0-1+b1'
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download "assimp-utils=$assimp" "libassimp5=$assimp" >/dev/null 2>&1
for package in *.deb; do dpkg-deb -x "$package" root; done
LD_LIBRARY_PATH="$(dirname "$(find "$PWD/root" -name 'libassimp.so.5' | head -1)")"
export LD_LIBRARY_PATH
echo "assimp-utils $assimp"

# dae PRIMITIVES: a cone of four sides, apex first.
dae() {
    cat <<END
<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><created>2026-01-01T00:00:00Z</created><modified>2026-01-01T00:00:00Z</modified><up_axis>Z_UP</up_axis></asset>
  <library_geometries><geometry id="cone"><mesh>
    <source id="places"><float_array id="places-array" count="15">0 0 2  1 0 0  0 1 0  -1 0 0  0 -1 0</float_array>
      <technique_common><accessor source="#places-array" count="5" stride="3">
        <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
      </accessor></technique_common></source>
    <vertices id="corners"><input semantic="POSITION" source="#places"/></vertices>
    $1
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="scene"><node id="part"><instance_geometry url="#cone"/></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
END
}
input='<input semantic="VERTEX" source="#corners" offset="0"/>'
fan="<trifans count=\"1\">$input<p>0 1 2 3 4 1</p></trifans>"
triangles="<triangles count=\"4\">$input<p>0 1 2  0 2 3  0 3 4  0 4 1</p></triangles>"
strips="<tristrips count=\"2\">$input<p>1 2 0 3</p><p>3 4 0 1</p></tristrips>"
dae "$fan" >fan.dae
dae "$triangles" >triangles.dae
dae "$strips" >strips.dae

failed=0
# expect WHAT SEEN EXPECTED
expect() {
    echo "$1: $2"
    [ "$2" = "$3" ] || { echo "  expected: $3" && failed=1; }
}
# faces FILE: corners of each face as written to .obj, or "no mesh".
faces() {
    rm -f "$1.obj"
    root/usr/bin/assimp export "$1.dae" "$1.obj" >"$1.log" 2>&1 || true
    [ -s "$1.obj" ] && grep -q '^f ' "$1.obj" || { echo 'no mesh' && return; }
    grep '^f ' "$1.obj" | awk '{ print NF - 1 }' | sort | uniq -c | awk '{ printf "%s%d of %d corners", sep, $1, $2; sep = ", " }'
}
# area FILE: of the triangles that -tri makes; the cone has 6.
area() {
    rm -f "$1.tri.obj"
    root/usr/bin/assimp export "$1.dae" "$1.tri.obj" -tri >"$1.log" 2>&1 || true
    awk '/^v / { n++; x[n] = $2; y[n] = $3; z[n] = $4 }
        /^f / { for (i = 2; i <= 4; ++i) { split($i, part, "/"); c[i] = part[1] }
            ax = x[c[3]] - x[c[2]]; ay = y[c[3]] - y[c[2]]; az = z[c[3]] - z[c[2]]
            bx = x[c[4]] - x[c[2]]; by = y[c[4]] - y[c[2]]; bz = z[c[4]] - z[c[2]]
            sum += 0.5 * sqrt((ay * bz - az * by) ^ 2 + (az * bx - ax * bz) ^ 2 + (ax * by - ay * bx) ^ 2) }
        END { printf "%.2f", sum }' "$1.tri.obj"
}
expect 'triangles' "$(faces triangles)" '4 of 3 corners'
expect 'two strips' "$(faces strips)" '4 of 3 corners'
expect 'a fan' "$(faces fan)" '1 of 6 corners'
expect 'triangles, area' "$(area triangles)" 6.00
expect 'two strips, area' "$(area strips)" 6.00
expect 'a fan, area' "$(area fan)" 2.00
exit "$failed"
