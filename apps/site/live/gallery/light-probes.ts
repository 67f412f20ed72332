/**
 * Light probes
 *
 * Balls that fly through a baked court take its reflected light from a grid of probes: red by the red wall, green by the green.
 *
 * @tags baking, effect
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { bakeProbes } from '@farol/bake';
import { LightProbes, type ProbeBox, ProbeGrid, probePoints, setBakedSurroundings } from '@farol/renderer/light-probes';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred', effects: [new LightProbes()] });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x0a0d16);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(0, 3.2, 8.4);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1, 0);
controls.update();

const add = (geometry: THREE.BufferGeometry, color: number, x: number, y: number, z: number) => {
  const mesh = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ color, roughness: 0.9 }));
  mesh.position.set(x, y, z);
  scene.add(mesh);
};
add(new THREE.BoxGeometry(9, 0.2, 5), 0xd8d0c4, 0, -0.1, 0);
add(new THREE.BoxGeometry(9, 3, 0.2), 0xe8e0d4, 0, 1.5, -2.5);
add(new THREE.BoxGeometry(0.2, 3, 5), 0xe03020, -4.5, 1.5, 0);
add(new THREE.BoxGeometry(0.2, 3, 5), 0x20b040, 4.5, 1.5, 0);
for (const x of [-1.5, 1.5]) add(new THREE.CylinderGeometry(0.3, 0.3, 3, 32), 0xf0ece4, x, 1.5, -1.4);
for (const x of [-3, 0, 3]) {
  const lamp = new THREE.PointLight(0xffe6c0, 16, 7);
  lamp.position.set(x, 2.7, 0.6);
  lamp.add(new THREE.Mesh(new THREE.SphereGeometry(0.08, 16, 12), new THREE.MeshBasicMaterial({ color: 0xfff0d8 })));
  scene.add(lamp);
}

const ball = new THREE.SphereGeometry(0.36, 48, 32);
const balls = Array.from({ length: 7 }, () => {
  const mesh = new THREE.Mesh(ball, new THREE.MeshStandardMaterial({ color: 0xffffff, roughness: 0.5 }));
  mesh.visible = false; // until the probes are there
  scene.add(mesh);
  return mesh;
});
const box: ProbeBox = { min: [-4.4, 0, -2.4], max: [4.4, 3, 2.4], counts: [9, 3, 5] };
/** Bakes the light at the points of the grid, and gives it to the scene. */
async function bake(): Promise<void> {
  const { coefficients } = await bakeProbes(webgl, scene, probePoints(box), { size: 128, bounces: 3, samples: 32 });
  setBakedSurroundings(scene, { grid: new ProbeGrid(box, coefficients), hasSky: false });
  for (const mesh of balls) mesh.visible = true;
}
const ready = bake();

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
  for (const [i, mesh] of balls.entries()) {
    const phase = 0.5 * seconds + 0.9 * i;
    mesh.position.set(3.9 * Math.sin(phase), 0.8 + 0.4 * Math.sin(2.3 * phase), 0.9 * Math.cos(1.3 * phase) + 0.3);
  }
  farol.render(scene, camera);
});

export { camera, farol, ready, scene, webgl };
