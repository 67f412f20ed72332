/**
 * Campfire
 *
 * Flames, embers and lit smoke: particles that shine on the stones round them and are lit by each other.
 *
 * @tags particles, effect
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
scene.background = new THREE.Color(0x05060a);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(1.8, 1.2, 3.4);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.8, 0);
controls.update();

const sand = new THREE.Mesh(
  new THREE.PlaneGeometry(30, 30),
  new THREE.MeshStandardMaterial({ color: 0x9a8466, roughness: 1 }),
);
sand.rotation.x = -Math.PI / 2;
scene.add(sand, new THREE.HemisphereLight(0x5a78c0, 0x100c08, 0.25));
const stone = new THREE.MeshStandardMaterial({ color: 0x8f8a84, roughness: 0.9, flatShading: true });
for (let i = 0; i < 13; i++) {
  const angle = (i / 13) * 2 * Math.PI;
  const rock = new THREE.Mesh(new THREE.IcosahedronGeometry(0.19 + 0.05 * Math.sin(4 * i), 1), stone);
  rock.position.set(0.8 * Math.cos(angle), 0.1, 0.8 * Math.sin(angle));
  rock.rotation.set(i, 2 * i, 0);
  scene.add(rock);
}
const log = new THREE.CylinderGeometry(0.09, 0.11, 1.1, 12);
const wood = new THREE.MeshStandardMaterial({ color: 0x4a3322, roughness: 1 });
for (let i = 0; i < 5; i++) {
  const mesh = new THREE.Mesh(log, wood);
  mesh.position.y = 0.25;
  mesh.rotation.set(1.05, (i / 5) * 2 * Math.PI, 0, 'YXZ');
  scene.add(mesh);
}
const tree = new THREE.ConeGeometry(0.8, 3, 9);
const green = new THREE.MeshStandardMaterial({ color: 0x3d5a42, roughness: 1 });
for (let i = 0; i < 18; i++) {
  const mesh = new THREE.Mesh(tree, green);
  const angle = (i / 18) * 2 * Math.PI;
  mesh.position.set((7 + (i % 3)) * Math.cos(angle), 1.5, (7 + (i % 3)) * Math.sin(angle));
  scene.add(mesh);
}
const emitters = [
  new ParticleEmitter({ ...particlePresets.fire, lightIntensity: 4.5 }),
  new ParticleEmitter({ ...particlePresets.smoke, rate: 24, capacity: 160 }),
  new ParticleEmitter({
    ...particlePresets.sparks,
    ...{ rate: 26, bursts: [], prewarm: 2, duration: 0, gravity: [0, 0.9, 0], speed: [0.6, 1.8], noiseStrength: 3 },
  }),
];
emitters[0].position.y = 0.15;
emitters[1].position.y = 1.3;
emitters[2].position.y = 0.3;
scene.add(...emitters);
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
  for (const emitter of emitters) emitter.step(timer.getDelta());
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
