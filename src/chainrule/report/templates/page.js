// A slider moves the drawn arm; pointing at the chart does the same. Nothing moves by itself.
document.querySelectorAll("[data-motion]").forEach(function (figure) {
  "use strict";
  var one = function (name) { return figure.querySelector(name); };
  var tracks = JSON.parse(one("script").textContent);
  var slider = one("input"), choice = one("select"), said = one(".said"), chart = one(".chart svg");
  var track = tracks[0];
  function show() {
    var k = Number(slider.value), points = track.frames[k], places = points.split(" ");
    one(".arm").setAttribute("points", points);
    figure.querySelectorAll(".joint").forEach(function (joint, i) {
      var at = places[i + 1].split(",");
      joint.setAttribute("cx", at[0]);
      joint.setAttribute("cy", at[1]);
    });
    var tip = places[places.length - 1].split(",");
    one(".tip").setAttribute("cx", tip[0]);
    one(".tip").setAttribute("cy", tip[1]);
    var mark = track.line.split(" ")[k].split(",");
    one(".cursor").setAttribute("x1", mark[0]);
    one(".cursor").setAttribute("x2", mark[0]);
    one(".mark").setAttribute("cx", mark[0]);
    one(".mark").setAttribute("cy", mark[1]);
    said.textContent = track.texts[k];
    slider.setAttribute("aria-valuetext", track.texts[k]);
  }
  function choose() {
    track = tracks[choice ? choice.selectedIndex : 0];
    slider.max = track.frames.length - 1;
    var ghosts = figure.querySelectorAll(".ghost");
    ghosts.forEach(function (ghost, i) {
      ghost.setAttribute("points", track.frames[Math.floor(i * track.frames.length / ghosts.length)]);
    });
    one(".line").setAttribute("points", track.line);
    one(".inside").setAttribute("d", track.inside);
    slider.value = track.start;
    show();
  }
  function point(event) {
    if (event.pointerType === "mouse" || event.buttons) {
      var box = chart.getBoundingClientRect(), frame = chart.viewBox.baseVal;
      var x = (event.clientX - box.left) * frame.width / box.width;
      var ends = [Number(chart.dataset.left), Number(chart.dataset.right)];
      slider.value = Math.round((x - ends[0]) / (ends[1] - ends[0]) * (track.frames.length - 1));
      show();
    }
  }
  one(".controls").hidden = false;
  figure.classList.add("live");
  slider.addEventListener("input", show);
  chart.addEventListener("pointermove", point);
  chart.addEventListener("pointerdown", point);
  if (choice) choice.addEventListener("change", choose);
  choose();
});
