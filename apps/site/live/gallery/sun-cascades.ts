/**
 * Sun with cascades
 *
 * One directional light with four shadow maps, each a quarter as far as the next: sharp at your feet, whole to the horizon.
 *
 * @tags shadows, directional light
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
webgl.toneMappingExposure = 0.75;
webgl.shadowMap.enabled = true;
const farol = new FarolRenderer(webgl, { technique: 'clustered-forward', shadowCascades: 4 });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x9fb4d0);
scene.fog = new THREE.Fog(0x9fb4d0, 60, 240);
const camera = new THREE.PerspectiveCamera(55, 1, 0.1, 300);
camera.position.set(2.6, 2.1, 10.5);
const controls = new OrbitControls(camera, canvas);
controls.target.set(-0.4, 2.3, -4);
controls.update();

const ground = new THREE.Mesh(
  new THREE.PlaneGeometry(600, 600),
  new THREE.MeshStandardMaterial({ color: 0xa89878, roughness: 0.95 }),
);
ground.rotation.x = -Math.PI / 2;
ground.receiveShadow = true;
const sun = new THREE.DirectionalLight(0xffe2b0, 4.2);
sun.position.set(-70, 48, -60);
sun.castShadow = true;
sun.shadow.mapSize.set(2048, 2048);
sun.shadow.normalBias = 0.05;
sun.shadow.intensity = 0.95;
Object.assign(sun.shadow.camera, { left: -130, right: 130, top: 130, bottom: -130, far: 320 });
scene.add(ground, sun, new THREE.HemisphereLight(0xa8c4f0, 0x806a50, 1.6));

const stone = new THREE.MeshStandardMaterial({ color: 0xe2d6c0, roughness: 0.8 });
const shaft = new THREE.CylinderGeometry(0.42, 0.52, 5, 20);
const beam = new THREE.BoxGeometry(1.4, 0.5, 4);
const PAIRS = 34;
const columns = new THREE.InstancedMesh(shaft, stone, 2 * PAIRS);
const beams = new THREE.InstancedMesh(beam, stone, 2 * PAIRS);
const matrix = new THREE.Matrix4();
for (let i = 0; i < 2 * PAIRS; i++) {
  const x = i % 2 ? 4.2 : -4.2;
  const z = 8 - 4 * Math.floor(i / 2);
  columns.setMatrixAt(i, matrix.makeTranslation(x, 2.5, z));
  beams.setMatrixAt(i, matrix.makeTranslation(x, 5.25, z));
}
for (const mesh of [columns, beams]) {
  mesh.castShadow = mesh.receiveShadow = true;
  mesh.frustumCulled = false;
  scene.add(mesh);
}
const statue = new THREE.Mesh(
  new THREE.TorusKnotGeometry(0.8, 0.26, 200, 32),
  new THREE.MeshStandardMaterial({ color: 0x6f8f7a, roughness: 0.35, metalness: 0.5 }),
);
statue.position.set(0, 2, 2);
statue.castShadow = statue.receiveShadow = true;
scene.add(statue);

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
  sun.position.set(-70, 44 + 14 * Math.sin(0.15 * seconds), -60 + 40 * Math.cos(0.15 * seconds));
  statue.rotation.y = 0.3 * seconds;
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
