/**
 * Photometric profiles
 *
 * Each lamp washes the wall by the light distribution of a luminaire (IES); the measured file says where its light goes.
 *
 * @tags spot light, profiles
 */
import { FarolRenderer } from '@farol/renderer';
import { setLightOptions } from '@farol/renderer/light-options';
import { PhotometricProfile, parseIES } from '@farol/renderer/light-profiles';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x050609);
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 100);
camera.position.set(0, 1.9, 10.4);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 2, 0);
controls.update();

const wall = new THREE.Mesh(
  new THREE.PlaneGeometry(24, 7, 1, 1),
  new THREE.MeshStandardMaterial({ color: 0xc9b8a0, roughness: 0.9 }),
);
wall.position.set(0, 3.5, 0);
const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(24, 10),
  new THREE.MeshStandardMaterial({ color: 0x3b3530, roughness: 0.4 }),
);
floor.rotation.x = -Math.PI / 2;
floor.position.z = 5;
scene.add(wall, floor, new THREE.HemisphereLight(0x8090c0, 0x302820, 0.08));

/** Text of an IES file (LM-63) whose luminaire gives `candelas` at each degree from straight down. */
function iesOf(candelas: (degrees: number) => number): string {
  const angles = Array.from({ length: 91 }, (_, i) => i * 2);
  const row = (numbers: number[]) => numbers.map((each) => each.toFixed(2)).join(' ');
  return `IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 91 1 1 2 0 0 0\n1 1 10\n${row(angles)}\n0\n${row(angles.map(candelas))}\n`;
}
const bell = (degrees: number, middle: number, width: number) => Math.exp(-(((degrees - middle) / width) ** 2));
const luminaires = [
  (v: number) => 900 * bell(v, 0, 12),
  (v: number) => 500 * bell(v, 0, 30) * (1 - 0.9 * bell(v, 0, 9)),
  (v: number) => 420 * bell(v, 18, 5) + 260 * bell(v, 42, 6) + 120 * bell(v, 0, 4),
  (v: number) => 300 * (bell(v, 20, 20) + bell(v, 160, 18)),
  (v: number) => 260 * Math.abs(Math.cos((v * Math.PI) / 30)) * (v < 75 ? 1 : 0),
  (v: number) => 620 * bell(v, 28, 7) * (1 + 0.6 * Math.sin(v)),
  (v: number) => 800 * bell(v, 0, 7) + 90 * bell(v, 60, 12),
];
const colors = [0xffe0b0, 0xffc890, 0xfff0dd, 0xffd8a8, 0xffb878, 0xfff4e6, 0xffcf9a];
const can = new THREE.CylinderGeometry(0.09, 0.12, 0.28, 24);
for (const [i, candelas] of luminaires.entries()) {
  const profile = new PhotometricProfile(parseIES(iesOf(candelas)));
  const light = new THREE.PointLight(colors[i], 15, 7);
  setLightOptions(light, { profile: profile.texture });
  light.position.set(1.72 * (i - 3), 3.2, 0.42);
  const lamp = new THREE.Mesh(
    can,
    new THREE.MeshStandardMaterial({ color: 0x22242a, emissive: colors[i], emissiveIntensity: 0.6 }),
  );
  lamp.position.y = 0.1;
  light.add(lamp);
  scene.add(light);
}

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  farol.setPixelRatio(Math.min(devicePixelRatio, 2));
  farol.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();

webgl.setAnimationLoop(() => farol.render(scene, camera));

export { camera, farol, scene, webgl };
