import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

/** Size of the page's canvas in CSS pixels, and device pixels for each. */
interface Size {
  width: number;
  height: number;
  ratio: number;
}

/** Messages of the page. */
type Message =
  | { type: 'start'; canvas: OffscreenCanvas; size: Size }
  | { type: 'resize'; size: Size }
  | { type: 'show'; isIntersecting: boolean }
  | { type: 'pointer'; event: string; values: Partial<PointerEvent> };

/** The canvas as OrbitControls needs it: a size, and a target of events. */
class CanvasEvents extends EventTarget {
  readonly style = {};
  readonly ownerDocument = this;
  clientWidth = 1;
  clientHeight = 1;

  setPointerCapture(): void {}
  releasePointerCapture(): void {}
}

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x05060a);
scene.fog = new THREE.Fog(0x05060a, 40, 110);
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 200);
camera.position.set(19, 9, 21);
const element = new CanvasEvents();
const controls = new OrbitControls(camera, element as unknown as HTMLElement);
controls.target.set(0, 1, 0);
controls.maxPolarAngle = 1.5;
controls.update();

const SIDE = 56;
const blocks = new THREE.InstancedMesh(
  new THREE.BoxGeometry(),
  new THREE.MeshStandardMaterial({ color: 0x9a9ca8, roughness: 0.4, metalness: 0.1 }),
  SIDE * SIDE,
);
const matrix = new THREE.Matrix4();
for (let i = 0; i < SIDE * SIDE; i++) {
  const x = (i % SIDE) - SIDE / 2;
  const z = Math.floor(i / SIDE) - SIDE / 2;
  const height = 0.4 + 2.6 * THREE.MathUtils.seededRandom() ** 3 * (1 + Math.sin(x / 6) * Math.cos(z / 7));
  matrix.makeScale(0.8, height, 0.8).setPosition(x, height / 2, z);
  blocks.setMatrixAt(i, matrix);
}
const ground = new THREE.Mesh(
  new THREE.PlaneGeometry(90, 90),
  new THREE.MeshStandardMaterial({ color: 0x55585f, roughness: 0.7 }),
);
ground.rotation.x = -Math.PI / 2;
scene.add(blocks, ground, new THREE.HemisphereLight(0x6f86c0, 0x101014, 0.12));

const lights: THREE.PointLight[] = [];
const bulbs = new THREE.InstancedMesh(new THREE.SphereGeometry(0.08, 8, 6), new THREE.MeshBasicMaterial(), 1000);
for (let i = 0; i < 1000; i++) {
  const light = new THREE.PointLight(new THREE.Color().setHSL(THREE.MathUtils.seededRandom(), 0.9, 0.55), 1.5, 3.6);
  lights.push(light);
  bulbs.setColorAt(i, light.color);
}
bulbs.frustumCulled = false;
scene.add(...lights, bulbs);

function move(seconds: number): void {
  for (let i = 0; i < lights.length; i++) {
    const lane = i % SIDE;
    const along = ((i * 7.31 + seconds * (1 + (i % 5) / 3)) % SIDE) - SIDE / 2;
    const across = lane - SIDE / 2 + 0.5;
    const height = 0.5 + 0.25 * (i % 9);
    lights[i].position.set(i % 2 ? along : across, height, i % 2 ? across : along);
    bulbs.setMatrixAt(i, matrix.makeTranslation(lights[i].position));
  }
  bulbs.instanceMatrix.needsUpdate = true;
}

// without it the first frames would be drawn by another technique
const code = FarolRenderer.preload();
let webgl: THREE.WebGLRenderer;
let farol: FarolRenderer;

function start(canvas: OffscreenCanvas, size: Size): void {
  webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
  webgl.toneMapping = THREE.ACESFilmicToneMapping;
  farol = new FarolRenderer(webgl);
  resize(size);
  show(true);
  void farol.ready.then(() => postMessage('drawn'));
  Object.assign(self, { live: { camera, farol, scene, webgl } }); // for the tests of the site
}

function show(isShown: boolean): void {
  void code.then(() => webgl.setAnimationLoop(isShown ? draw : null));
}

function draw(milliseconds: number): void {
  move(milliseconds / 1000);
  farol.render(scene, camera);
}

function resize({ width, height, ratio }: Size): void {
  element.clientWidth = width;
  element.clientHeight = height;
  camera.aspect = width / height;
  camera.updateProjectionMatrix();
  farol.setPixelRatio(ratio);
  farol.setSize(width, height, false); // false: the page sets the canvas's style
}

addEventListener('message', ({ data }: MessageEvent<Message>) => {
  if (data.type === 'start') start(data.canvas, data.size);
  else if (data.type === 'resize') resize(data.size);
  else if (data.type === 'show') show(data.isIntersecting);
  else element.dispatchEvent(Object.assign(new Event(data.event), data.values));
});
