/**
 * BatchedMesh market
 *
 * Many shapes with a place and colour of their own in one BatchedMesh, drawn by one call, culled one by one.
 *
 * @tags instancing, many lights
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x08060a);
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 100);
camera.position.set(7.5, 4.6, 9.5);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.6, 0);
controls.update();

const shapes: THREE.BufferGeometry[] = [
  new THREE.SphereGeometry(0.3, 24, 16),
  new THREE.BoxGeometry(0.5, 0.5, 0.5),
  new THREE.ConeGeometry(0.3, 0.7, 24),
  new THREE.TorusGeometry(0.26, 0.1, 12, 32),
  new THREE.CylinderGeometry(0.2, 0.28, 0.6, 20),
  new THREE.DodecahedronGeometry(0.32),
];
const vertices = shapes.reduce((sum, { attributes }) => sum + attributes.position.count, 0);
const indices = shapes.reduce((sum, { index, attributes }) => sum + (index?.count ?? attributes.position.count), 0);
const COUNT = 400;
const batch = new THREE.BatchedMesh(
  COUNT,
  vertices,
  indices,
  new THREE.MeshStandardMaterial({ roughness: 0.4, metalness: 0.15 }),
);
const ids = shapes.map((shape) => {
  if (shape.index === null) shape.setIndex([...Array(shape.attributes.position.count).keys()]);
  return batch.addGeometry(shape);
});
const place = new THREE.Object3D();
const color = new THREE.Color();
for (let i = 0; i < COUNT; i++) {
  const instance = batch.addInstance(ids[i % ids.length]);
  const [x, z] = [(i % 20) - 9.5, Math.floor(i / 20) - 9.5];
  place.position.set(0.8 * x, 0.4 + 0.3 * Math.sin(x) * Math.cos(z), 0.8 * z);
  place.rotation.set(0, i, i % 4 === 3 ? 1.2 : 0);
  place.updateMatrix();
  batch.setMatrixAt(instance, place.matrix);
  batch.setColorAt(instance, color.setHSL((0.07 * i) % 1, 0.55, 0.6));
}
const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(40, 40),
  new THREE.MeshStandardMaterial({ color: 0x50484a, roughness: 0.5 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(batch, floor, new THREE.HemisphereLight(0xa0b0e0, 0x302820, 0.25));
const bulb = new THREE.SphereGeometry(0.07, 16, 12);
const lamps = Array.from({ length: 36 }, (_, i) => {
  const lamp = new THREE.PointLight(new THREE.Color().setHSL(0.04 + 0.015 * (i % 6), 0.9, 0.62), 6, 4);
  lamp.add(new THREE.Mesh(bulb, new THREE.MeshBasicMaterial({ color: 0xffe0b8 })));
  lamp.position.set(3 * ((i % 6) - 2.5), 1.5, 3 * (Math.floor(i / 6) - 2.5));
  scene.add(lamp);
  return lamp;
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
  for (const [i, lamp] of lamps.entries()) lamp.position.y = 1.5 + 0.3 * Math.sin(seconds + 1.7 * i);
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
