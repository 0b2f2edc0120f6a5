#!/bin/bash
# What one would guess: a DirectX .x file in text form, whose frame moves a mesh by (5, 6, 7), is read with the mesh
# there, by whatever reads .x.
# What it is: OpenSceneGraph's plug-in leaves the mesh at the origin without a word, since it does not read
# FrameTransformMatrix, and refuses the same file if the mesh has no MeshMaterialList, which the format leaves optional. Assimp
# moves the mesh, but refuses a matrix of whole numbers without blanks ("1,0,0,0,"): it takes the comma that separates two
# numbers for a decimal comma, so that "1,0" is one number and eight of sixteen are missing. "1.0,0.0," and "1, 0," are read.
# Version: openscenegraph 3.6.5+dfsg1-8+b2, assimp-utils 5.2.5~ds0-1+b1 (Debian 12). Source: DirectX SDK, "X File Format
# Reference", templates Frame, FrameTransformMatrix and Mesh; the behaviour printed below.
# Why it matters here: parts of a model that is read by the first stand in one heap with no error, and its signature is that of the
# heap. Our reader gives Assimp the text with a blank behind every comma between numbers, and keeps the frames.
set -euo pipefail

osg='3.6.5+dfsg1-8+b2' assimp='5.2.5~ds0-1+b1'
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download "openscenegraph=$osg" "libopenscenegraph161=$osg" libopenthreads21 "assimp-utils=$assimp" "libassimp5=$assimp" >/dev/null 2>&1
for package in *.deb; do dpkg-deb -x "$package" root; done
LD_LIBRARY_PATH="$(dirname "$(find "$PWD/root" -name 'libassimp.so.5' | head -1)")"
OSG_LIBRARY_PATH="$(dirname "$(find "$PWD/root" -name 'osgdb_x.so' | head -1)")"
export LD_LIBRARY_PATH OSG_LIBRARY_PATH
echo "openscenegraph $osg, assimp-utils $assimp"

# x_file MATRIX MATERIAL: a plate in a moved frame.
x_file() {
    cat <<END
xof 0303txt 0032
Frame moved {
  FrameTransformMatrix {
    $1;;
  }
  Mesh plate {
    4;
    0.0;0.0;0.0;,
    1.0;0.0;0.0;,
    1.0;1.0;0.0;,
    0.0;1.0;0.0;;
    2;
    3;0,1,2;,
    3;0,2,3;;
$2
  }
}
END
}
points='1.0,0.0,0.0,0.0, 0.0,1.0,0.0,0.0, 0.0,0.0,1.0,0.0, 5.0,6.0,7.0,1.0'
whole='1,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,7,1'
blanks='1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1'
material='    MeshMaterialList {
      1;
      2;
      0,
      0;
      Material grey {
        0.5;0.5;0.5;1.0;;
        1.0;
        0.0;0.0;0.0;;
        0.0;0.0;0.0;;
      }
    }'
x_file "$points" "$material" >points.x
x_file "$points" '' >bare.x
x_file "$whole" "$material" >whole.x
x_file "$blanks" "$material" >blanks.x

failed=0
# expect WHAT SEEN EXPECTED
expect() {
    echo "$1: $2"
    [ "$2" = "$3" ] || { echo "  expected: $3" && failed=1; }
}
# by_osg FILE: whether a transform was read.
by_osg() {
    rm -f "$1.osgt"
    root/usr/bin/osgconv "$1.x" "$1.osgt" >/dev/null 2>&1 || true
    [ -s "$1.osgt" ] || { echo refused && return; }
    if grep -q MatrixTransform "$1.osgt"; then echo moved; else echo "not moved"; fi
}
# by_assimp FILE: x of the first corner.
by_assimp() {
    rm -f "$1.obj"
    root/usr/bin/assimp export "$1.x" "$1.obj" >/dev/null 2>&1 || true
    [ -s "$1.obj" ] || { echo refused && return; }
    if grep '^v ' "$1.obj" | awk '$2 < 5 || $2 > 6 { off = 1 } END { exit off }'; then echo moved; else echo "not moved"; fi
}
expect 'OpenSceneGraph, matrix with decimal points' "$(by_osg points)" 'not moved'
expect 'OpenSceneGraph, no material list' "$(by_osg bare)" refused
expect 'Assimp, matrix with decimal points' "$(by_assimp points)" moved
expect 'Assimp, no material list' "$(by_assimp bare)" moved
expect 'Assimp, whole numbers without blanks' "$(by_assimp whole)" refused
expect 'Assimp, whole numbers with blanks' "$(by_assimp blanks)" moved
exit "$failed"
