/**
 * Lights a pixel pays for
 *
 * The view `light-count` shows how many lights each pixel goes through; the technique decides, so choose one.
 *
 * @tags views, technique, cost, many lights
 */
import { FarolRenderer, techniques } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { TechniqueName, View } from '@farol/renderer';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'tiled-deferred', view: 'light-count', heatMapMaximum: 48 });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x05060a);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(7, 6, 10);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.6, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(40, 40),
  new THREE.MeshStandardMaterial({ color: 0x8d929c, roughness: 0.6 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0x8fa8d8, 0x202028, 0.2));
const pillars = new THREE.InstancedMesh(
  new THREE.CylinderGeometry(0.28, 0.34, 2.6, 24),
  new THREE.MeshStandardMaterial({ color: 0xd9d2c4, roughness: 0.5 }),
  49,
);
for (let i = 0; i < 49; i++) {
  pillars.setMatrixAt(i, new THREE.Matrix4().makeTranslation(2.2 * ((i % 7) - 3), 1.3, 2.2 * (Math.floor(i / 7) - 3)));
}
scene.add(pillars);
const lights = Array.from({ length: 120 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL((i * 0.11) % 1, 0.8, 0.6), 5, 3.4);
  scene.add(light);
  return light;
});

const panel = document.createElement('div');
panel.className = 'panel';
const technique = document.createElement('select');
technique.ariaLabel = 'Technique';
technique.append(...Object.entries(techniques).map(([name, { label }]) => new Option(label, name)));
technique.value = farol.technique;
technique.addEventListener('change', () => (farol.technique = technique.value as TechniqueName));
const view = document.createElement('select');
view.ariaLabel = 'View';
view.append(
  new Option('Lights a pixel', 'light-count'),
  new Option('Overdraw', 'overdraw'),
  new Option('Picture', 'final'),
);
view.addEventListener('change', () => (farol.view = view.value as View));
panel.append(technique, view);
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
    const angle = 0.25 * seconds + i;
    light.position.set(
      2.2 * ((i % 7) - 3) + 0.9 * Math.cos(angle),
      0.4 + 0.35 * (i % 6),
      2.2 * ((Math.floor(i / 7) % 7) - 3) + 0.9 * Math.sin(angle),
    );
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
