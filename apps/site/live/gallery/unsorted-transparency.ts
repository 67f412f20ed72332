/**
 * Transparency without an order
 *
 * Rings that pass through one another: WeightedBlendedOIT averages their layers, where sorting whole objects must fail.
 *
 * @tags transparency, effect
 */
import { FarolRenderer } from '@farol/renderer';
import { WeightedBlendedOIT } from '@farol/renderer/transparency';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-forward', effects: [new WeightedBlendedOIT()] });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x0c0e15);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(0, 1.4, 7);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0, 0);
controls.update();

scene.add(new THREE.HemisphereLight(0xc0d0ff, 0x403830, 0.9));
const rings = Array.from({ length: 14 }, (_, i) => {
  const color = new THREE.Color().setHSL(i / 14, 0.85, 0.55);
  const ring = new THREE.Mesh(
    new THREE.TorusGeometry(1.1 + 0.11 * i, 0.24, 24, 96),
    new THREE.MeshStandardMaterial({
      color,
      transparent: true,
      opacity: 0.4,
      roughness: 0.25,
      depthWrite: false,
      side: THREE.DoubleSide,
    }),
  );
  scene.add(ring);
  return ring;
});
const core = new THREE.Mesh(
  new THREE.IcosahedronGeometry(0.5, 4),
  new THREE.MeshStandardMaterial({ color: 0xfff0d8, roughness: 0.3 }),
);
scene.add(core);
const lights = Array.from({ length: 12 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL(i / 12, 0.6, 0.65), 9, 5);
  scene.add(light);
  return light;
});
const box = document.createElement('label');
box.className = 'panel';
const check = Object.assign(document.createElement('input'), { type: 'checkbox', checked: true });
const [oit] = farol.effects;
check.addEventListener('change', () => (farol.effects = check.checked ? [oit] : []));
box.append(check, 'Weighted, blended, in no order');
document.body.append(box);

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
  for (const [i, ring] of rings.entries()) ring.rotation.set(0.2 * seconds + 0.45 * i, 0.15 * seconds + 0.8 * i, 0);
  for (const [i, light] of lights.entries()) {
    light.position.set(
      2.6 * Math.cos(0.5 * seconds + i),
      1.6 * Math.sin(0.4 * seconds + 2 * i),
      2.4 * Math.sin(0.5 * seconds + i),
    );
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
