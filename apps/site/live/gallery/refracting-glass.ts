/**
 * Refracting glass
 *
 * Transmission, thickness and dispersion of three's MeshPhysicalMaterial, with thirty lamps seen through it.
 *
 * @tags transparency, transmission, materials
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x0a0c12);
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 100);
camera.position.set(0, 1.5, 6);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.1, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.CircleGeometry(8, 96),
  new THREE.MeshStandardMaterial({ color: 0x39404c, roughness: 0.3 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0xbfd4ff, 0x302820, 0.5));

const glass = new THREE.MeshPhysicalMaterial({
  transmission: 1,
  thickness: 0.9,
  roughness: 0.03,
  ior: 1.5,
  dispersion: 4,
  attenuationColor: 0xbfe8ff,
  attenuationDistance: 4,
});
const gem = new THREE.Mesh(new THREE.IcosahedronGeometry(0.95, 0), glass);
gem.position.set(-1.6, 1.05, 0.2);
const teapot = new THREE.Mesh(new TeapotGeometry(0.75, 18), glass);
teapot.position.set(0.8, 0.8, 0.5);
scene.add(gem, teapot);
const rods = new THREE.InstancedMesh(
  new THREE.CylinderGeometry(0.09, 0.09, 3, 24),
  new THREE.MeshStandardMaterial({ roughness: 0.3 }),
  17,
);
for (let i = 0; i < 17; i++) {
  rods.setMatrixAt(i, new THREE.Matrix4().makeTranslation(0.5 * (i - 8), 1.5, -2.2));
  rods.setColorAt(i, new THREE.Color().setHSL(i / 17, 0.6, 0.55));
}
scene.add(rods);
const bulb = new THREE.SphereGeometry(0.05, 16, 12);
const lamps = Array.from({ length: 30 }, (_, i) => {
  const lamp = new THREE.PointLight(new THREE.Color().setHSL(i / 30, 0.75, 0.6), 2.2, 3.5);
  lamp.add(new THREE.Mesh(bulb, new THREE.MeshBasicMaterial({ color: lamp.color })));
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
  gem.rotation.set(0.3 * seconds, 0.4 * seconds, 0);
  for (const [i, lamp] of lamps.entries()) {
    const angle = (i / 30) * 2 * Math.PI + 0.2 * seconds;
    lamp.position.set(3.2 * Math.cos(angle), 0.5 + 0.45 * (i % 4), 2 * Math.sin(angle) - 0.4);
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
