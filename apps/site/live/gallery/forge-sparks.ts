/**
 * Sparks that bounce
 *
 * Every third spark is a light of its own: they fly from the anvil, bounce off floor and ball, and light what they pass.
 *
 * @tags particles, effect
 * @still 1.1 22
 */
import { FarolRenderer } from '@farol/renderer';
import { ParticleEmitter, Particles, particlePresets } from '@farol/renderer/particles';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'tiled-deferred', effects: [new Particles()] });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x050507);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(2.2, 1.3, 3);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.7, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(20, 20),
  new THREE.MeshStandardMaterial({ color: 0x5c5850, roughness: 0.6 }),
);
floor.rotation.x = -Math.PI / 2;
const iron = new THREE.MeshStandardMaterial({ color: 0x8a8f96, roughness: 0.35, metalness: 0.6 });
const foot = new THREE.Mesh(new THREE.CylinderGeometry(0.16, 0.34, 0.5, 6), iron);
foot.position.y = 0.25;
const anvil = new THREE.Mesh(new RoundedBoxGeometry(0.9, 0.24, 0.36, 4, 0.05), iron);
anvil.position.y = 0.6;
const horn = new THREE.Mesh(new THREE.ConeGeometry(0.14, 0.5, 24), iron);
horn.position.set(0.65, 0.62, 0);
horn.rotation.z = -Math.PI / 2;
const blade = new THREE.Mesh(
  new THREE.BoxGeometry(0.8, 0.03, 0.09),
  new THREE.MeshBasicMaterial({ color: new THREE.Color(4, 1.1, 0.2) }),
);
blade.position.set(-0.15, 0.74, 0.05);
const ball = new THREE.Mesh(
  new THREE.SphereGeometry(0.35, 48, 32),
  new THREE.MeshStandardMaterial({ color: 0xc8ccd2, roughness: 0.2, metalness: 0.8 }),
);
ball.position.set(1, 0.35, 0.9);
const wall = new THREE.Mesh(
  new THREE.PlaneGeometry(12, 6),
  new THREE.MeshStandardMaterial({ color: 0x7a6a5c, roughness: 0.9 }),
);
wall.position.set(0, 3, -1.6);
scene.add(floor, foot, anvil, horn, blade, ball, wall, new THREE.HemisphereLight(0x6a7ac0, 0x201408, 0.2));
const glow = new THREE.PointLight(0xff7a30, 2.5, 4);
glow.position.set(-0.1, 1, 0.2);
scene.add(glow);
const sparks = new ParticleEmitter({
  ...particlePresets.sparks,
  bursts: [{ time: 0, count: 260 }],
  shape: { kind: 'cone', radius: 0.03, angle: 1 },
  colliders: [
    { kind: 'plane', normal: [0, 1, 0], height: 0, bounce: 0.5, friction: 0.25 },
    { kind: 'sphere', center: [1, 0.35, 0.9], radius: 0.36, bounce: 0.6, friction: 0.1 },
    { kind: 'plane', normal: [0, 0, 1], height: -1.58, bounce: 0.4, friction: 0.2 },
  ],
  lightIntensity: 0.35,
  lightRange: 1.2,
  size: [0.02, 0.04],
});
sparks.position.set(-0.1, 0.78, 0.05);
scene.add(sparks);
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
  sparks.step(timer.getDelta());
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
