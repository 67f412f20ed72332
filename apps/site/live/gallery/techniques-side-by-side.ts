/**
 * Two techniques, one picture
 *
 * Left of the line by one technique, right of it by another: the same picture, at another price.
 *
 * @tags technique, start
 */
import { FarolRenderer, techniques } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { TechniqueName } from '@farol/renderer';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl);

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x06070b);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(5, 3.2, 7);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(30, 30),
  new THREE.MeshStandardMaterial({ color: 0x85807a, roughness: 0.5 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0x8fa8d8, 0x302820, 0.2));
const ball = new THREE.SphereGeometry(0.42, 48, 32);
for (let i = 0; i < 25; i++) {
  const material = new THREE.MeshStandardMaterial({
    color: 0xe8e0d4,
    roughness: 0.08 + 0.22 * (i % 5),
    metalness: Math.floor(i / 5) / 4,
  });
  const mesh = new THREE.Mesh(ball, material);
  mesh.position.set(1.1 * ((i % 5) - 2), 0.42, 1.1 * (Math.floor(i / 5) - 2));
  scene.add(mesh);
}
const bulb = new THREE.SphereGeometry(0.05, 16, 12);
const lights = Array.from({ length: 32 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL((i * 0.618) % 1, 0.8, 0.6), 2.6, 3);
  light.add(new THREE.Mesh(bulb, new THREE.MeshBasicMaterial({ color: light.color })));
  scene.add(light);
  return light;
});

const panel = document.createElement('div');
panel.className = 'panel';
const sides = (['clustered-forward', 'light-prepass'] as TechniqueName[]).map((name, side) => {
  const select = document.createElement('select');
  select.ariaLabel = side ? 'Right' : 'Left';
  select.append(...Object.entries(techniques).map(([key, { label }]) => new Option(label, key)));
  select.value = name;
  panel.append(select);
  return select;
});
document.body.append(panel);
const right = new FarolRenderer(webgl); // two renderers may share one canvas
const line = document.createElement('div');
line.style.cssText = 'position: fixed; inset: 0 auto 0 50%; width: 2px; background: #fffa; pointer-events: none';
document.body.append(line);

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
    const radius = 0.55 * Math.sqrt(i);
    light.position.set(radius * Math.cos(angle), 1 + 0.25 * (i % 4), radius * Math.sin(angle));
  }
  farol.technique = sides[0].value as TechniqueName;
  right.technique = sides[1].value as TechniqueName;
  webgl.setScissorTest(true);
  webgl.setScissor(Math.floor(innerWidth / 2), 0, Math.ceil(innerWidth / 2), innerHeight);
  right.render(scene, camera);
  webgl.setScissor(0, 0, Math.floor(innerWidth / 2), innerHeight);
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
