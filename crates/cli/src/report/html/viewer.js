// The view of a solid that turns: the scene of the page, drawn with three.js.
//
// The scene is in lengths of the part's radius, about its center. Nothing is computed here but
// where things stand on the screen.
(() => {
  "use strict";
  const figure = document.getElementById("solid");
  const data = JSON.parse(document.getElementById("scene").textContent);
  const canvas = figure.querySelector("canvas");
  const names = figure.querySelector(".names");

  // The colors of the still pictures.
  const INK = 0x1e2228, GREY = 0x6b727c, PART = 0xdde3ea, BLUE = 0x0b4f8a, ORANGE = 0xd5650a;
  const GREEN = 0x008060, PURPLE = 0x8a1f75;
  // Sizes, in radii of the part.
  const CONE = 0.24, BALL_LIMIT = 0.5, ARROW = 0.45, REACH = 1.2, ROOM = 1.3;
  // Edges between faces that differ by less (degrees) are not drawn.
  const SMOOTH = 20;
  // What one key turns (rad) and zooms.
  const TURN = Math.PI / 24, ZOOM = 1.15;

  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
  } catch {
    return; // The still picture stays.
  }
  renderer.setClearColor(0xffffff);
  figure.classList.add("live");

  const scene = new THREE.Scene();
  const camera = new THREE.OrthographicCamera();
  camera.up.set(0, 0, 1);
  const controls = new THREE.OrbitControls(camera, canvas);
  controls.minZoom = 0.3;
  controls.maxZoom = 60;
  const light = new THREE.DirectionalLight(0xffffff, 1.6);
  scene.add(light, new THREE.AmbientLight(0xffffff, 1.9));

  const vector = (array) => new THREE.Vector3(...array);
  const labels = [];

  /** A name that stays beside a point; that of something on a face turned away is pale. */
  function label(parent, text, at, color, normal) {
    if (!text) return;
    const element = document.createElement("span");
    element.textContent = text;
    element.style.color = "#" + color.toString(16).padStart(6, "0");
    names.append(element);
    labels.push({ element, parent, at: at.clone(), normal });
  }

  /** Something seen through the part too, but faintly. */
  function seen(parent, make) {
    const [front, behind] = [make({}), make({ depthTest: false, transparent: true, opacity: 0.22 })];
    front.renderOrder = 2;
    behind.renderOrder = 1;
    parent.add(behind, front);
    return [front, behind];
  }

  function solid(parent, geometry, color, place) {
    const [front, behind] = seen(parent, (more) =>
      new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color, ...more })));
    for (const mesh of [front, behind]) place(mesh);
  }

  /** Places a shape that stands along y so that it stands along a direction. */
  const along = (at, direction) => (mesh) => {
    mesh.position.copy(at);
    mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), direction.clone().normalize());
  };

  function line(parent, from, to, color, dash) {
    const geometry = new THREE.BufferGeometry().setFromPoints([from, to]);
    const material = (more) => dash
      ? new THREE.LineDashedMaterial({ color, dashSize: 0.09, gapSize: 0.035, ...more })
      : new THREE.LineBasicMaterial({ color, ...more });
    const made = (more) => new THREE.LineSegments(geometry, material(more));
    for (const segment of seen(parent, made)) segment.computeLineDistances();
  }

  /** An arrow that ends at its tip. */
  function arrow(parent, tip, direction, length, color) {
    if (!(length > 0)) return;
    const unit = direction.clone().normalize();
    const head = Math.min(0.1, 0.6 * length);
    const back = (by) => tip.clone().addScaledVector(unit, -by);
    const shaft = length - head;
    solid(parent, new THREE.ConeGeometry(0.36 * head, head, 20), color, along(back(head / 2), unit));
    if (shaft > 0) {
      const geometry = new THREE.CylinderGeometry(0.012, 0.012, shaft, 10);
      solid(parent, geometry, color, along(back(head + shaft / 2), unit));
    }
  }

  const part = new THREE.BufferGeometry();
  part.setAttribute("position", new THREE.BufferAttribute(new Float32Array(data.positions), 3));
  part.setIndex(data.triangles);
  const faces = part.toNonIndexed();
  faces.computeVertexNormals();
  const edges = new THREE.EdgesGeometry(faces, SMOOTH);
  scene.add(new THREE.Mesh(faces, new THREE.MeshLambertMaterial({
    color: PART, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  })));
  scene.add(new THREE.LineSegments(edges, new THREE.LineBasicMaterial({ color: INK })));
  scene.add(new THREE.LineSegments(edges, new THREE.LineBasicMaterial({
    color: GREY, depthTest: false, transparent: true, opacity: 0.18,
  })));

  function finger(parent, { point, normal, radius, label: name, force, push, fixed }) {
    const [tip, inward] = [vector(point), vector(normal)];
    const out = (by) => tip.clone().addScaledVector(inward, -by);
    const color = fixed ? GREEN : BLUE;
    let back = CONE;
    if (radius > 0 && radius <= BALL_LIMIT) {
      solid(parent, new THREE.SphereGeometry(radius, 32, 20), color, along(out(radius), inward));
      back = 2 * radius;
    } else {
      solid(parent, new THREE.ConeGeometry(0.055, CONE, 24), color, along(out(CONE / 2), inward));
    }
    if (fixed) {
      const foot = new THREE.CylinderGeometry(0.1, 0.1, 0.03, 4);
      solid(parent, foot, color, along(out(back), inward));
    }
    const length = ARROW * (push || 0);
    arrow(parent, out(back + 0.02), inward, length, color);
    label(parent, force ? `${name}: ${force}` : name, out(back + length + 0.06), color, inward);
  }

  const fingers = new THREE.Group();
  scene.add(fingers);
  for (const one of data.fingers) finger(fingers, one);

  for (const { point, direction, label: name, strong } of data.axes) {
    const [at, unit] = [vector(point), vector(direction).normalize()];
    // The stretch of the axis around the middle of the part.
    const middle = at.clone().addScaledVector(unit, -at.dot(unit));
    const end = (side) => middle.clone().addScaledVector(unit, side * REACH);
    const color = strong ? ORANGE : GREY;
    line(scene, end(-1), end(1), color, true);
    if (strong) {
      const ring = new THREE.TorusGeometry(0.09, 0.008, 8, 40, 1.6 * Math.PI);
      solid(scene, ring, color, (mesh) => {
        mesh.position.copy(end(-0.93));
        mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), unit);
      });
    }
    label(scene, name, end(1.05), color);
  }

  if (data.center) {
    const at = vector(data.center.point);
    solid(scene, new THREE.SphereGeometry(0.03, 24, 16), ORANGE, (mesh) => mesh.position.copy(at));
    label(scene, data.center.label, at, ORANGE);
  }
  if (data.worst) {
    const [at, unit] = [vector(data.worst.point), vector(data.worst.direction).normalize()];
    solid(scene, new THREE.SphereGeometry(0.03, 24, 16), PURPLE, (mesh) => mesh.position.copy(at));
    for (const side of [-1, 1]) {
      const way = unit.clone().multiplyScalar(side);
      arrow(scene, at.clone().addScaledVector(way, 0.24), way, 0.21, PURPLE);
    }
    label(scene, data.worst.label, at, PURPLE);
  }

  // The displaced part under each load case, exaggerated.
  const cases = data.cases.map(({ translation, rotation, forces }) => {
    const group = new THREE.Group();
    const moved = new THREE.Group();
    const [x, y, z] = rotation;
    // To first order, as it is computed: p + v + omega x p.
    moved.matrix.set(1, -z, y, translation[0], z, 1, -x, translation[1],
      -y, x, 1, translation[2], 0, 0, 0, 1);
    moved.matrixAutoUpdate = false;
    moved.add(new THREE.Mesh(faces, new THREE.MeshLambertMaterial({
      color: ORANGE, transparent: true, opacity: 0.16, depthWrite: false,
    })));
    const material = new THREE.LineBasicMaterial({ color: ORANGE });
    moved.add(new THREE.LineSegments(edges, material));
    group.add(moved);
    for (const { point, direction, label: name } of forces) {
      const [at, unit] = [vector(point), vector(direction).normalize()];
      arrow(group, at, unit, ARROW, PURPLE);
      label(group, name, at.clone().addScaledVector(unit, -ARROW - 0.05), PURPLE);
    }
    group.visible = false;
    scene.add(group);
    return group;
  });

  function render() {
    light.position.copy(camera.position).addScaledVector(camera.up, 2)
      .addScaledVector(new THREE.Vector3().crossVectors(camera.up, camera.position), -0.4);
    renderer.render(scene, camera);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const eye = camera.position.clone().sub(controls.target);
    for (const { element, parent, at, normal } of labels) {
      const shown = at.clone().project(camera);
      element.hidden = !parent.visible;
      element.classList.toggle("behind", Boolean(normal) && normal.dot(eye) > 0);
      const [left, top] = [(shown.x + 1) / 2 * width, (1 - shown.y) / 2 * height];
      element.style.transform =
        `translate(-50%, -50%) translate(${left.toFixed(1)}px, ${top.toFixed(1)}px)`;
    }
  }

  function resize() {
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (!width || !height) return;
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    renderer.setSize(width, height, false);
    const narrow = Math.min(width, height);
    [camera.right, camera.top] = [ROOM * width / narrow, ROOM * height / narrow];
    [camera.left, camera.bottom] = [-camera.right, -camera.top];
    [camera.near, camera.far] = [-50, 50];
    camera.updateProjectionMatrix();
    render();
  }

  function look(direction) {
    controls.target.set(0, 0, 0);
    camera.zoom = 1;
    camera.position.copy(vector(direction).normalize().multiplyScalar(5));
    camera.updateProjectionMatrix();
    controls.update();
    render();
  }

  /** Turns about the vertical, and up or down. */
  function turn(around, up) {
    const eye = camera.position.clone().sub(controls.target);
    const [far, flat] = [eye.length(), Math.hypot(eye.x, eye.y)];
    const limit = Math.PI / 2 - 0.001;
    const height = Math.max(-limit, Math.min(limit, Math.atan2(eye.z, flat) + up));
    const angle = Math.atan2(eye.y, eye.x) + around;
    eye.set(Math.cos(height) * Math.cos(angle), Math.cos(height) * Math.sin(angle),
      Math.sin(height)).multiplyScalar(far);
    camera.position.copy(controls.target).add(eye);
    controls.update();
    render();
  }

  function zoom(by) {
    camera.zoom = Math.max(controls.minZoom, Math.min(controls.maxZoom, camera.zoom * by));
    camera.updateProjectionMatrix();
    render();
  }

  const keys = {
    ArrowLeft: () => turn(-TURN, 0), ArrowRight: () => turn(TURN, 0),
    ArrowUp: () => turn(0, TURN), ArrowDown: () => turn(0, -TURN),
    "+": () => zoom(ZOOM), "=": () => zoom(ZOOM), "-": () => zoom(1 / ZOOM),
    "0": () => look(data.view),
  };
  canvas.addEventListener("keydown", (event) => {
    const act = keys[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act();
  });

  const views = {
    first: data.view, front: [0, -1, 0], right: [1, 0, 0], top: [0, -0.0001, 1],
  };
  for (const button of figure.querySelectorAll("button[data-view]")) {
    button.addEventListener("click", () => look(views[button.dataset.view]));
  }
  for (const choice of figure.querySelectorAll("input[name=shown]")) {
    choice.addEventListener("change", () => {
      cases.forEach((group, i) => { group.visible = choice.value === String(i); });
      render();
    });
  }

  controls.addEventListener("change", render);
  new ResizeObserver(resize).observe(canvas);
  look(data.view);
  resize();
})();
