/**
 * Instanced meadow
 *
 * Forty thousand blades of grass in one draw call a material, under two hundred wandering lamps.
 *
 * @tags instancing, many lights
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'tiled-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x04070a);
scene.fog = new THREE.Fog(0x04070a, 8, 24);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 60);
camera.position.set(0, 2, 8.5);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.7, 0);
controls.update();

const blade = new THREE.ConeGeometry(0.025, 0.8, 3, 2, true);
const bend = blade.attributes.position;
for (let i = 0; i < bend.count; i++) {
  const height = bend.getY(i) + 0.4;
  bend.setXYZ(i, bend.getX(i) + 0.35 * height * height, height, bend.getZ(i));
}
blade.computeVertexNormals();
const grass = new THREE.InstancedMesh(
  blade,
  new THREE.MeshStandardMaterial({ color: 0x7a9a50, roughness: 0.6 }),
  40_000,
);
const place = new THREE.Object3D();
const tint = new THREE.Color();
for (let i = 0; i < grass.count; i++) {
  place.position.set(26 * (THREE.MathUtils.seededRandom() - 0.5), 0, 26 * (THREE.MathUtils.seededRandom() - 0.65));
  place.rotation.y = 6.3 * THREE.MathUtils.seededRandom();
  place.scale.setScalar(0.6 + 0.8 * THREE.MathUtils.seededRandom());
  place.updateMatrix();
  grass.setMatrixAt(i, place.matrix);
  grass.setColorAt(i, tint.setHSL(0.22 + 0.08 * THREE.MathUtils.seededRandom(), 0.5, 0.6));
}
const earth = new THREE.Mesh(
  new THREE.PlaneGeometry(60, 60),
  new THREE.MeshStandardMaterial({ color: 0x2c2a20, roughness: 1 }),
);
earth.rotation.x = -Math.PI / 2;
scene.add(grass, earth, new THREE.HemisphereLight(0x6080c0, 0x101810, 0.35));
const lamps = new THREE.InstancedMesh(
  new THREE.SphereGeometry(0.035, 10, 8),
  new THREE.MeshBasicMaterial({ color: 0xffe0a0 }),
  200,
);
lamps.frustumCulled = false;
scene.add(lamps);
const matrix = new THREE.Matrix4();
const lights = Array.from({ length: 200 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL(i % 5 ? 0.11 : 0.45, 0.9, 0.6), 1.1, 2.4);
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
  for (const [i, { position }] of lights.entries()) {
    const angle = 0.35 * seconds * (i % 2 ? 1 : -1) + 2.4 * i;
    const radius = 0.78 * Math.sqrt(i);
    position.set(radius * Math.cos(angle), 0.7 + 0.4 * Math.sin(seconds + 3 * i), radius * Math.sin(angle) - 2);
    lamps.setMatrixAt(i, matrix.makeTranslation(position));
  }
  lamps.instanceMatrix.needsUpdate = true;
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
