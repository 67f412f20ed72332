/**
 * Morph targets under coloured light
 *
 * A ball becomes a flower, a star and a pillow; each morph is lit by two dozen lamps and keeps its shadows.
 *
 * @tags animation, shadows
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
webgl.shadowMap.enabled = true;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x06060a);
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 100);
camera.position.set(0, 1.9, 5.4);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.15, 0);
controls.update();

const ball = new THREE.IcosahedronGeometry(0.8, 40);
const base = ball.attributes.position as THREE.BufferAttribute;
const at = new THREE.Vector3();
/** Morph target that has the ball's points at other distances from its middle. */
function target(distance: (theta: number, phi: number) => number): THREE.BufferAttribute {
  const moved = base.clone();
  for (let i = 0; i < base.count; i++) {
    at.fromBufferAttribute(base, i).normalize();
    at.multiplyScalar(0.8 * distance(Math.atan2(at.z, at.x), Math.asin(at.y)));
    moved.setXYZ(i, at.x, at.y, at.z);
  }
  return moved;
}
ball.morphAttributes.position = [
  target((theta, phi) => 1 + 0.34 * Math.sin(6 * theta) * Math.cos(phi) ** 3),
  target((theta, phi) => 0.75 + 0.5 * (Math.cos(5 * theta) * Math.cos(phi) * Math.cos(4 * phi)) ** 2),
  target((theta, phi) => 1 - 0.3 * Math.cos(4 * theta) * Math.sin(3 * phi)),
];
const normals = ball.morphAttributes.position.map((position) => {
  const shape = new THREE.BufferGeometry().setAttribute('position', position);
  const merged = mergeVertices(shape);
  merged.computeVertexNormals();
  return position.clone().copyArray(smoothNormals(merged, position.count));
});
ball.morphAttributes.normal = normals;

/** Normals of `merged`, whose coinciding vertices are one, for each vertex of the geometry before merging. */
function smoothNormals(merged: THREE.BufferGeometry, count: number): Float32Array {
  const all = new Float32Array(3 * count);
  const { normal } = merged.attributes;
  for (let i = 0; i < count; i++) {
    const k = merged.index!.getX(i);
    all.set([normal.getX(k), normal.getY(k), normal.getZ(k)], 3 * i);
  }
  return all;
}
const thing = new THREE.Mesh(ball, new THREE.MeshStandardMaterial({ color: 0xf0e6da, roughness: 0.3 }));
thing.position.y = 1.3;
thing.castShadow = thing.receiveShadow = true;
thing.morphTargetInfluences = [0, 0, 0];
const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(30, 30),
  new THREE.MeshStandardMaterial({ color: 0x8d8478, roughness: 0.6 }),
);
floor.rotation.x = -Math.PI / 2;
floor.receiveShadow = true;
scene.add(thing, floor, new THREE.HemisphereLight(0x90a0e0, 0x302820, 0.12));
for (const [x, color] of [
  [-2.4, 0xff3a6a],
  [2.4, 0x2a6aff],
] as const) {
  const spot = new THREE.SpotLight(color, 60, 12, 0.5, 0.6);
  spot.position.set(x, 3.6, 2.2);
  spot.target = thing;
  spot.castShadow = true;
  spot.shadow.normalBias = 0.03;
  scene.add(spot);
}
const lights = Array.from({ length: 20 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL(0.08 + 0.03 * (i % 4), 0.9, 0.6), 1.6, 3);
  light.add(new THREE.Mesh(new THREE.SphereGeometry(0.03, 12, 8), new THREE.MeshBasicMaterial({ color: 0xffe0b0 })));
  scene.add(light);
  return light;
});

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
  for (let i = 0; i < 3; i++) thing.morphTargetInfluences![i] = Math.max(0, Math.sin(0.7 * seconds + 2.1 * i)) ** 0.7;
  thing.rotation.x = 0.9;
  thing.rotation.y = 0.2 * seconds;
  for (const [i, light] of lights.entries()) {
    const angle = 0.4 * seconds + (i / 20) * 2 * Math.PI;
    light.position.set(1.6 * Math.cos(angle), 0.25 + 0.5 * (i % 4), 1.6 * Math.sin(angle));
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
