/**
 * It picks the technique itself
 *
 * `auto` looks at what is in view; the line says what it took, and why. Move the slider from 1 to 400 lamps.
 *
 * @tags start, technique, cost
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl);

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x06070b);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(5, 4.4, 7.6);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.4, 0);
controls.update();

const tile = new RoundedBoxGeometry(0.9, 0.9, 0.9, 3, 0.08);
const tiles = new THREE.InstancedMesh(
  tile,
  new THREE.MeshStandardMaterial({ color: 0xb8b4ac, roughness: 0.4, metalness: 0.2 }),
  196,
);
for (let i = 0; i < 196; i++) {
  const x = (i % 14) - 6.5;
  const z = Math.floor(i / 14) - 6.5;
  tiles.setMatrixAt(i, new THREE.Matrix4().makeTranslation(x, 0.7 * Math.sin(0.6 * x) * Math.cos(0.5 * z) - 0.5, z));
}
scene.add(tiles, new THREE.HemisphereLight(0x8fa8e0, 0x302820, 0.25));
const bulb = new THREE.SphereGeometry(0.06, 12, 8);
const lights = Array.from({ length: 400 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL((i * 0.618) % 1, 0.8, 0.6), 2.2, 2.6);
  light.add(new THREE.Mesh(bulb, new THREE.MeshBasicMaterial({ color: light.color })));
  scene.add(light);
  return light;
});
const panel = document.createElement('label');
panel.className = 'panel';
const slider = Object.assign(document.createElement('input'), { type: 'range', min: '1', max: '400', value: '60' });
const output = document.createElement('output');
panel.append('Lamps ', slider, output);
document.body.append(panel);
function show(): void {
  for (const [i, light] of lights.entries()) light.visible = i < Number(slider.value);
}
slider.addEventListener('input', show);
show();

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  farol.setPixelRatio(Math.min(devicePixelRatio, 2));
  farol.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();

webgl.setAnimationLoop((milliseconds) => {
  const seconds = milliseconds / 1000;
  for (const [i, light] of lights.entries()) {
    const angle = 0.25 * seconds * (i % 2 ? 1 : -1) + 2.4 * i;
    const radius = 0.34 * Math.sqrt(i + 1) + 0.3;
    light.position.set(radius * Math.cos(angle), 1 + 0.25 * Math.sin(seconds + i), radius * Math.sin(angle));
  }
  output.value = `${slider.value}: ${farol.info.technique}, ${farol.info.reason}`;
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
