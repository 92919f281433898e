// SPDX-License-Identifier: LGPL-2.1-or-later
// Plays the frames of actuation.html. Given: FRAMES, how many; DATA, corners of all triangles, frame
// by frame, as 16-bit numbers in base64; TIMES and ENERGIES; DOING, the load case; MARKS, of some
// frames whether a tile has an open contact, and HUE, the hue and the saturation of such tiles.
const bytes = Uint8Array.from(atob(DATA), (letter) => letter.charCodeAt(0));
const corners = new Int16Array(bytes.buffer);
const perFrame = corners.length / FRAMES, count = perFrame / 9;
const canvas = document.getElementById("piece"), pen = canvas.getContext("2d");
const slider = document.getElementById("frame"), button = document.getElementById("play");
const shown = new Float64Array(perFrame), order = new Array(count), depth = new Float64Array(count);
let yaw = 0.6, tilt = 1.0, playing = false, began = 0;

function draw() {
  const k = Number(slider.value), first = k * perFrame;
  const scale = 0.48 * Math.min(canvas.width, canvas.height) / 32767;
  const [c, s, ct, st] = [Math.cos(yaw), Math.sin(yaw), Math.cos(tilt), Math.sin(tilt)];
  for (let i = 0; i < perFrame; i += 3) {
    const x = corners[first + i], y = corners[first + i + 1], z = corners[first + i + 2];
    const along = s * x + c * y;
    shown[i] = canvas.width / 2 + scale * (c * x - s * y);
    shown[i + 1] = canvas.height / 2 - scale * (ct * along + st * z);
    shown[i + 2] = -st * along + ct * z;
  }
  for (let t = 0; t < count; t++) {
    order[t] = t;
    depth[t] = shown[9 * t + 2] + shown[9 * t + 5] + shown[9 * t + 8];
  }
  order.sort((a, b) => depth[a] - depth[b]);
  pen.clearRect(0, 0, canvas.width, canvas.height);
  pen.lineWidth = 0.7;
  pen.strokeStyle = "#5d4a1d";
  for (const t of order) {
    const a = 9 * t, ux = shown[a + 3] - shown[a], uy = shown[a + 4] - shown[a + 1];
    const vx = shown[a + 6] - shown[a], vy = shown[a + 7] - shown[a + 1];
    const facing = uy * vx - ux * vy;
    const uz = scale * (shown[a + 5] - shown[a + 2]), vz = scale * (shown[a + 8] - shown[a + 2]);
    const area = Math.hypot(facing, uy * vz - uz * vy, uz * vx - ux * vz);
    const light = 38 + 40 * Math.abs(facing) / (area || 1);
    const [hue, strength] = (MARKS[k] || [])[t] ? HUE : (facing > 0 ? [38, 70] : [212, 25]);
    pen.fillStyle = `hsl(${hue}, ${strength}%, ${light}%)`;
    pen.beginPath();
    pen.moveTo(shown[a], shown[a + 1]);
    pen.lineTo(shown[a + 3], shown[a + 4]);
    pen.lineTo(shown[a + 6], shown[a + 7]);
    pen.closePath();
    pen.fill();
    pen.stroke();
  }
  document.getElementById("at").textContent = `Frame ${k + 1} of ${FRAMES}, ${DOING[k]}: ` +
    `${TIMES[k].toPrecision(3)} s, ${ENERGIES[k].toFixed(0)} N mm`;
}

function play(now) {
  if (!playing) return;
  began = began || now - 80 * Number(slider.value);
  const k = Math.min(Math.floor((now - began) / 80), FRAMES - 1);
  slider.value = k;
  draw();
  if (k === FRAMES - 1) return stop();
  requestAnimationFrame(play);
}

function stop() {
  playing = false;
  button.textContent = "Play";
}

button.onclick = () => {
  if (playing) return stop();
  playing = true;
  began = 0;
  button.textContent = "Stop";
  if (Number(slider.value) === FRAMES - 1) slider.value = 0;
  requestAnimationFrame(play);
};
slider.oninput = () => { stop(); draw(); };
canvas.onpointermove = (event) => {
  if (!event.buttons) return;
  yaw += event.movementX / 150;
  tilt -= event.movementY / 150;
  draw();
};
draw();
