#!/usr/bin/env bash
# Draws every kind of frame, at two sizes and in both themes, and every kind of figure, by the program itself, onto one
# page: tests/gallery.sh PLUMB FOLDER. Each picture's caption is the command that drew it, run in FOLDER.
set -euo pipefail

here=$(realpath "$(dirname "$0")")
plumb=$(realpath "$1")
mkdir -p "$2"
cd "$2"
cases=$(realpath --relative-to=. "$here/../cases")
page=index.html.new

escaped() { sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g' <<<"$1"; }

# A word as a shell needs it.
shown() {
  local text="plumb" word
  for word in "$@"; do
    case $word in
      *[\ \[\]\{\}\"\;]*) text+=" '$word'" ;;
      *) text+=" $word" ;;
    esac
  done
  escaped "$text"
}

section() { printf '<h2>%s</h2>\n<p>%s</p>\n' "$1" "$2" >>"$page"; }

# One kind of frame: TITLE, NAME, then what `plumb render` is told besides size and theme.
frame() {
  local title=$1 name=$2 theme size file
  shift 2
  printf '<h3>%s</h3>\n<div class="four">\n' "$title" >>"$page"
  for theme in light dark; do
    for size in 960x540 480x270; do
      file=frames/${name}_${theme}_$size.png
      "$plumb" render "$@" --size $size --set scene.theme=$theme -o - --quiet >"$file"
      printf '<a class="%s" href="%s"><img src="%s" alt="%s, %s, %s" loading="lazy"></a>\n' \
        $theme "$file" "$file" "$title" $theme $size >>"$page"
    done
  done
  printf '</div>\n<pre>%s</pre>\n' "$(shown render "$@" --size 960x540 --set scene.theme=light -o -) &gt; frame.png" >>"$page"
}

# The figures of a folder, with the command that made it: TITLE, FOLDER, then the arguments of plumb.
figures() {
  local title=$1 folder=$2 status=0 file
  shift 2
  "$plumb" "$@" -o "$folder" --quiet >"$folder.log" 2>&1 || status=$?
  # A criterion that is not met is no fault of a picture.
  if [ $status -gt 1 ]; then
    cat "$folder.log" >&2
    exit $status
  fi
  printf '<h3>%s</h3>\n<pre>%s</pre>\n<div class="figures">\n' "$title" "$(shown "$@" -o "$folder")" >>"$page"
  for file in "$folder"/figures/*.png; do
    printf '<figure><a href="%s"><img src="%s" alt="%s" loading="lazy"></a><figcaption>%s</figcaption></figure>\n' \
      "$file" "$file" "$(basename "$file" .png)" "$(basename "$file")" >>"$page"
  done
  printf '</div>\n' >>"$page"
}

rm -rf frames runs figures marks
mkdir -p frames runs figures marks
cat >"$page" <<'HTML'
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Plumb: every kind of picture</title>
<style>
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; color: #2b3038; background: #fff; max-width: 1240px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.7em; margin-bottom: 0; }
h2 { margin: 2.2em 0 0; border-top: 1px solid #d5dae1; padding-top: .8em; }
h3 { margin: 1.6em 0 .4em; font-size: 1.05em; }
p { margin: .3em 0; color: #5a626e; }
pre { background: #f3f5f8; padding: .5em .8em; font-size: 12px; white-space: pre-wrap; margin: .5em 0; border-radius: 4px; }
img { display: block; max-width: 100%; height: auto; }
.four { display: grid; grid-template-columns: 2fr 1fr 2fr 1fr; gap: 8px; align-items: start; }
.four a { box-shadow: 0 0 0 1px #d5dae1; background: #fff; }
.four a.dark { background: #14181e; }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(360px, 1fr)); gap: 16px; align-items: start; }
figure { margin: 0; }
figcaption { font-size: 12px; color: #5a626e; }
@media (max-width: 700px) { .four { grid-template-columns: 1fr 1fr; } }
</style>
</head>
<body>
<h1>Every kind of picture</h1>
<p>Drawn by the program, frames at two sizes and in both themes. A picture opens in its own size. The commands were run in the
folder of this page.</p>
HTML

for mesh in 4 16; do
  "$plumb" solve "$cases/pendulum.toml" --set cable.elements=$mesh -o runs/mesh_$mesh --quiet
done
"$plumb" solve "$cases/pendulum.toml" --set 'supports.first="clamped"' --set 'supports.last="pinned"' \
  --set 'start.angular_velocity=[0,0,0]' -o runs/held --quiet
run=runs/mesh_16
at=(--frames 24)

section "Cameras" "The run has 16 elements; the time is 0.96 s."
for camera in fit front back left right top bottom orbit follow; do
  frame "Camera: $camera" camera_$camera $run "${at[@]}" --camera $camera
done
frame "Camera: where it is told to stand" camera_given $run "${at[@]}" \
  --set 'scene.camera={eye=[2.2,0.6,2.4],target=[0,-0.35,0],field_of_view=34}'
section "Supports" "A ball for a joint, a sleeve for a clamp."
frame "Clamped and pinned" supports runs/held --frames 3
section "Backgrounds" "The page shows through what is transparent."
for background in scene plain transparent; do
  frame "Background: $background" background_$background $run "${at[@]}" --set scene.background=$background
done
section "Colours by a field" "Of the whole run, with one legend."
for field in axial-strain axial-force curvature bending-moment speed; do
  frame "Coloured by $field" field_$field $run "${at[@]}" --set scene.color_by=$field
done
section "Earlier times" "Ghosts of the cable, and the tip's way."
frame "Ghosts" ghosts $run "${at[@]}" --set scene.ghosts=6 --set scene.ghost_interval=0.06
frame "Ghosts coloured by speed" ghosts_speed $run "${at[@]}" --set scene.ghosts=6 --set scene.ghost_interval=0.06 \
  --set scene.color_by=speed
frame "No trail" no_trail $run "${at[@]}" --set scene.trail=0
frame "A long trail" long_trail $run --frames 50 --set scene.trail=2
section "Several runs, and points" "Four elements held against 16, and against published points."
frame "Over one another" over runs/mesh_4 "${at[@]}" --over runs/mesh_16
frame "Side by side" beside runs/mesh_4 "${at[@]}" --beside runs/mesh_16
frame "Points of references" points runs/mesh_4 "${at[@]}" --over runs/mesh_16 --camera top --points
frame "Thick cable" thick $run "${at[@]}" --set scene.cable_radius=0.03
for samples in 1 2 3 4; do
  frame "Supersampling of $samples" samples_$samples $run "${at[@]}" --set scene.supersampling=$samples
done

section "Tiles" "Larger than the renderer draws at once, so in tiles; shown smaller."
"$plumb" render $run "${at[@]}" --size 17000x3000 --set scene.supersampling=1 -o - --quiet >frames/tiles.png
printf '<a href="frames/tiles.png"><img src="frames/tiles.png" alt="tiles" loading="lazy"></a>\n<pre>%s</pre>\n' \
  "$(shown render $run "${at[@]}" --size 17000x3000 --set scene.supersampling=1 -o -) &gt; frame.png" >>"$page"

section "Figures" "Of short forms of each study, which say nothing of their subjects. Figures have one size and one theme, for paper."
figures "A run, with its quick study" figures/run run "$cases/pendulum.toml"
figures "Work against precision" figures/work_precision study "$cases/pendulum.toml" work-precision \
  --set time.end=0.2 --set study.work_precision.end=0.2 --set 'study.work_precision.elements=[4,8]' \
  --set study.work_precision.points=4 --set study.work_precision.repeats=1 --set study.work_precision.time_limit=0.1 \
  --set 'study.work_precision.methods=["rk4","generalized-alpha","cvode-bdf"]'
figures "Where methods fail" figures/stability study "$cases/pendulum.toml" stability \
  --set time.end=0.1 --set time.output_interval=0.01 --set cable.elements=4 --set 'study.stability.elements=[2,4,8]' \
  --set 'study.stability.parameter_values=[2,5,20]' --set 'study.stability.durations=[0.05,0.1]' \
  --set 'study.stability.methods=["rk4","trapezoidal","cvode-bdf"]' --set study.stability.steps=6 \
  --set study.stability.largest_step=0.01 --set study.stability.smallest_step=5e-4 \
  --set study.stability.tightest_tolerance=1e-5 --set 'study.stability.limit_methods=["rk4"]'
figures "Random cases" figures/sweep study "$cases/failure/random_sweep.toml" sweep --set study.sweep.cases=12
figures "Variants that fail in known ways" figures/variants study "$cases/failure/axial_locking.toml" variants

section "What differs between two pictures" "By plumb diff: what was added is blue, what went is red."
"$plumb" render runs/mesh_4 "${at[@]}" -o - --quiet >marks/a.png
"$plumb" render runs/mesh_16 "${at[@]}" -o - --quiet >marks/b.png
"$plumb" diff marks/a.png marks/b.png --html marks/index.html --quiet || [ $? -eq 1 ]
printf '<p><a href="marks/index.html">The page of the comparison</a></p>\n<pre>%s</pre>\n' \
  "$(shown diff marks/a.png marks/b.png --html marks/index.html)" >>"$page"

printf '</body>\n</html>\n' >>"$page"
mv "$page" index.html
echo "gallery: $PWD/index.html, $(find . -name '*.png' | wc -l) pictures"
