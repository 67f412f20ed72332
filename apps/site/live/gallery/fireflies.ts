/**
 * Fireflies
 *
 * Every glowing particle is a light: the GPU moves four hundred of them and lights the forest, at no cost to the CPU.
 *
 * @tags particles, many lights, effect
 */
import { FarolRenderer } from '@farol/renderer';
import { ParticleEmitter, Particles, particlePresets } from '@farol/renderer/particles';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'tiled-deferred', effects: [new Particles()] });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x04070d);
scene.fog = new THREE.Fog(0x04070d, 7, 20);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(0, 1.5, 7.5);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.1, 0);
controls.update();

const earth = new THREE.Mesh(
  new THREE.PlaneGeometry(40, 40),
  new THREE.MeshStandardMaterial({ color: 0x4b4a38, roughness: 1 }),
);
earth.rotation.x = -Math.PI / 2;
scene.add(earth, new THREE.HemisphereLight(0x6a8ad0, 0x0c140c, 0.6));
const bark = new THREE.MeshStandardMaterial({ color: 0x8a705a, roughness: 0.9 });
const leaf = new THREE.MeshStandardMaterial({ color: 0x6f9a5a, roughness: 0.8, side: THREE.DoubleSide });
const trunks = new THREE.InstancedMesh(new THREE.CylinderGeometry(0.12, 0.26, 6, 12), bark, 40);
const ferns = new THREE.InstancedMesh(new THREE.ConeGeometry(0.5, 0.5, 7, 1, true), leaf, 160);
const place = new THREE.Object3D();
for (let i = 0; i < 160; i++) {
  const angle = 2.4 * i;
  const radius = 1 + 0.55 * Math.sqrt(3 * i);
  place.position.set(radius * Math.cos(angle), 0.15, radius * Math.sin(angle) - 2);
  place.rotation.set(Math.PI, angle, 0.2 * Math.sin(9 * i));
  place.scale.setScalar(0.6 + 0.7 * THREE.MathUtils.seededRandom());
  place.updateMatrix();
  ferns.setMatrixAt(i, place.matrix);
  if (i % 4 !== 3) continue;
  place.position.y = 2.9;
  place.rotation.set(0, angle, 0.08 * Math.sin(7 * i));
  place.updateMatrix();
  trunks.setMatrixAt(Math.floor(i / 4), place.matrix);
}
scene.add(trunks, ferns);
const swarm = new ParticleEmitter({
  ...particlePresets.fireflies,
  rate: 45,
  capacity: 450,
  shape: { kind: 'box', size: [10, 2, 9] },
  lightIntensity: 1,
  lightRange: 2,
  brightness: 3,
});
swarm.position.set(0, 1.1, -0.5);
scene.add(swarm);
const timer = new THREE.Timer();

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  farol.setPixelRatio(Math.min(devicePixelRatio, 2));
  farol.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();

webgl.setAnimationLoop(() => {
  timer.update();
  swarm.step(timer.getDelta());
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
