/**
 * Render to a target
 *
 * Cameras draw the same lit scene into textures, and a wall of monitors shows them: `setRenderTarget`, then `farol.render`.
 *
 * @tags targets, many lights
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-forward' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x060709);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(0.7, 1.9, 5.4);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.7, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(30, 30),
  new THREE.MeshStandardMaterial({ color: 0x5c6068, roughness: 0.35 }),
);
floor.rotation.x = -Math.PI / 2;
const robot = new THREE.Group();
const steel = new THREE.MeshStandardMaterial({ color: 0xd8b060, roughness: 0.3, metalness: 0.7 });
const add = (geometry: THREE.BufferGeometry, x: number, y: number, z: number) => {
  const mesh = new THREE.Mesh(geometry, steel);
  mesh.position.set(x, y, z);
  robot.add(mesh);
};
add(new RoundedBoxGeometry(0.9, 0.9, 0.7, 4, 0.12), 0, 0.9, 0);
add(new THREE.SphereGeometry(0.36, 32, 20), 0, 1.65, 0);
for (const x of [-0.62, 0.62]) add(new THREE.CapsuleGeometry(0.13, 0.6, 8, 20), x, 0.85, 0);
for (const x of [-0.25, 0.25]) add(new THREE.CapsuleGeometry(0.16, 0.3, 8, 20), x, 0.3, 0);
robot.position.z = 1.6;
scene.add(floor, robot, new THREE.HemisphereLight(0x90a8e0, 0x302820, 0.25));
const lights = Array.from({ length: 16 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL(i / 16, 0.85, 0.6), 5, 4);
  scene.add(light);
  return light;
});
const eyes = Array.from({ length: 6 }, (_, i) => {
  const target = new THREE.WebGLRenderTarget(256, 160, { type: THREE.HalfFloatType, samples: 4 });
  const eye = new THREE.PerspectiveCamera(50, 1.6, 0.1, 30);
  const screen = new THREE.Mesh(
    new THREE.PlaneGeometry(1.76, 1.1),
    new THREE.MeshBasicMaterial({ map: target.texture, toneMapped: false }),
  );
  screen.position.set(2 * ((i % 3) - 1), i < 3 ? 2.8 : 1.5, -1.2);
  screen.rotation.y = -0.25 * ((i % 3) - 1);
  const frame = new THREE.Mesh(
    new RoundedBoxGeometry(1.9, 1.24, 0.1, 3, 0.04),
    new THREE.MeshStandardMaterial({ color: 0x16181c, roughness: 0.4 }),
  );
  frame.position.z = -0.07;
  screen.add(frame);
  scene.add(screen);
  return { eye, target };
});
let turn = 0;

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
  robot.rotation.y = 0.5 * seconds;
  for (const [i, light] of lights.entries()) {
    const angle = 0.4 * seconds + (i / 16) * 2 * Math.PI;
    light.position.set(2.6 * Math.cos(angle), 0.5 + 0.5 * (i % 5), 1.6 + 2.2 * Math.sin(angle));
  }
  for (const [i, { eye, target }] of eyes.entries()) {
    if (i % 3 !== turn % 3) continue; // two of the six cameras draw in each frame
    const angle = (i / 6) * 2 * Math.PI + 0.2 * seconds;
    eye.position.set(2.3 * Math.cos(angle), 0.6 + 0.5 * i, 1.6 + 2.3 * Math.sin(angle));
    eye.lookAt(0, 1.1, 1.6);
    webgl.setRenderTarget(target);
    farol.render(scene, eye);
  }
  webgl.setRenderTarget(null);
  turn++;
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
