/**
 * A frame budget
 *
 * `farol.budget = { frame: 16.7 }` draws at the scale that holds the time, and enlarges the picture by FSR 1.
 *
 * @tags cost, anti-aliasing, many lights
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: false });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'tiled-deferred', budget: { frame: 16.7, min: 0.5, max: 1 } });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x07090f);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(5, 3.4, 8);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(50, 50),
  new THREE.MeshStandardMaterial({ color: 0x6f747e, roughness: 0.5 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0x90a8e0, 0x302820, 0.2));
const knots = new THREE.InstancedMesh(
  new THREE.TorusKnotGeometry(0.5, 0.17, 128, 20),
  new THREE.MeshStandardMaterial({ color: 0xd8cfc0, roughness: 0.3, metalness: 0.5 }),
  49,
);
const place = new THREE.Object3D();
for (let i = 0; i < 49; i++) {
  place.position.set(2 * ((i % 7) - 3), 0.85, 2 * (Math.floor(i / 7) - 3));
  place.rotation.set(i, 2 * i, 3 * i);
  place.updateMatrix();
  knots.setMatrixAt(i, place.matrix);
}
scene.add(knots);
const lights = Array.from({ length: 300 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL((i * 0.618) % 1, 0.8, 0.6), 0.8, 2.6);
  scene.add(light);
  return light;
});
const panel = document.createElement('label');
panel.className = 'panel';
const slider = Object.assign(document.createElement('input'), { type: 'range', min: '4', max: '60', step: '0.1' });
slider.value = '16.7';
slider.addEventListener('input', () => (farol.budget = { frame: Number(slider.value), min: 0.5, max: 1 }));
const output = document.createElement('output');
panel.append('Milliseconds a frame ', slider, output);
document.body.append(panel);

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
    const angle = 0.3 * seconds * (i % 2 ? 1 : -1) + 2.4 * i;
    const radius = 0.42 * Math.sqrt(i);
    light.position.set(radius * Math.cos(angle), 0.4 + 0.3 * (i % 5), radius * Math.sin(angle));
  }
  const { budget } = farol.info;
  if (budget) output.value = `${slider.value} ms: scale ${budget.scale.toFixed(2)}`;
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
