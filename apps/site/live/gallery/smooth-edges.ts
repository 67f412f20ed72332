/**
 * Smooth edges, four ways
 *
 * None, SMAA, multisampled edges and TAA, on the worst of all scenes: thin fences and wires.
 *
 * @tags effect, anti-aliasing
 */
import { FarolRenderer } from '@farol/renderer';
import { MultisampledEdges, SMAA, TAA } from '@farol/renderer/antialiasing';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { FarolEffect } from '@farol/renderer';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: false });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-forward', effects: [new TAA()] });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x0b0e16);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(3.4, 1.9, 5.4);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(40, 40),
  new THREE.MeshStandardMaterial({ color: 0x7d8086, roughness: 0.7 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0xb0c4ff, 0x504840, 0.6));
const steel = new THREE.MeshStandardMaterial({ color: 0xe6e9ee, roughness: 0.5, metalness: 0.1 });
const fence = new THREE.InstancedMesh(new THREE.CylinderGeometry(0.012, 0.012, 1.8, 8), steel, 160);
const place = new THREE.Object3D();
for (let i = 0; i < 160; i++) {
  const angle = (i / 160) * 2 * Math.PI;
  place.position.set(2.4 * Math.cos(angle), 0.9, 2.4 * Math.sin(angle));
  place.rotation.set(0.35 * Math.sin(8 * angle), 0, 0.35 * Math.cos(8 * angle));
  place.updateMatrix();
  fence.setMatrixAt(i, place.matrix);
}
const star = new THREE.Mesh(
  new THREE.IcosahedronGeometry(0.9, 1),
  new THREE.MeshStandardMaterial({ color: 0xffb454, roughness: 0.4, wireframe: true }),
);
star.position.y = 1.2;
const heart = new THREE.Mesh(
  new THREE.IcosahedronGeometry(0.6, 1),
  new THREE.MeshStandardMaterial({ color: 0xb8442e, roughness: 0.35, flatShading: true }),
);
heart.position.y = 1.2;
scene.add(fence, star, heart);
for (let i = 0; i < 9; i++) {
  const light = new THREE.PointLight(new THREE.Color().setHSL(i / 9, 0.7, 0.65), 9, 6);
  light.position.set(3.1 * Math.cos(0.7 * i), 0.5 + 0.25 * i, 3.1 * Math.sin(0.7 * i));
  scene.add(light);
}

const ways: Record<string, FarolEffect[]> = {
  TAA: [...farol.effects],
  'Multisampled edges': [new MultisampledEdges()],
  SMAA: [new SMAA()],
  None: [],
};
const select = document.createElement('select');
select.className = 'panel';
select.ariaLabel = 'Anti-aliasing';
select.append(...Object.keys(ways).map((way) => new Option(way)));
select.addEventListener('change', () => (farol.effects = ways[select.value]));
document.body.append(select);

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
  star.rotation.y = 0.1 * seconds;
  heart.rotation.y = -0.1 * seconds;
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
