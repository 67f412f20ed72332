/**
 * Area lights
 *
 * Rectangles, discs and tubes that light and mirror as what they are, with soft shadows.
 *
 * @tags area light, shadows
 */
import { FarolRenderer } from '@farol/renderer';
import { setLightOptions } from '@farol/renderer/light-options';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
webgl.shadowMap.enabled = true;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x040507);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(0, 2.1, 8.2);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.2, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(30, 30),
  new THREE.MeshStandardMaterial({ color: 0x30343c, roughness: 0.32 }),
);
floor.rotation.x = -Math.PI / 2;
floor.receiveShadow = true;
const wall = new THREE.Mesh(
  new THREE.PlaneGeometry(30, 8),
  new THREE.MeshStandardMaterial({ color: 0xb4b6bc, roughness: 0.9 }),
);
wall.position.set(0, 4, -3);
wall.receiveShadow = true;
scene.add(floor, wall);

const clay = new THREE.MeshStandardMaterial({ color: 0xe6e0d6, roughness: 0.35 });
const pots: THREE.Mesh[] = [];
for (const [i, geometry] of [
  new THREE.TorusKnotGeometry(0.5, 0.18, 160, 24),
  new TeapotGeometry(0.6, 14),
  new THREE.IcosahedronGeometry(0.75, 0),
].entries()) {
  const pot = new THREE.Mesh(geometry, clay);
  pot.position.set(2.4 * (i - 1), 0.85, 0.3);
  pot.castShadow = pot.receiveShadow = true;
  scene.add(pot);
  pots.push(pot);
}

/** Adds an area light and a glowing mesh of its shape. */
function shine(
  color: number,
  intensity: number,
  shape: 'rectangle' | 'disc' | 'tube',
  size: [number, number],
): THREE.RectAreaLight {
  const light = new THREE.RectAreaLight(color, intensity, ...size);
  setLightOptions(light, { shape });
  const geometry =
    shape === 'tube'
      ? new THREE.CylinderGeometry(size[1] / 2, size[1] / 2, size[0], 20).rotateZ(Math.PI / 2)
      : shape === 'disc'
        ? new THREE.CircleGeometry(size[0] / 2, 48).rotateY(Math.PI)
        : new THREE.PlaneGeometry(...size).rotateY(Math.PI);
  light.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ color })));
  scene.add(light);
  return light;
}
const panel = shine(0xffb070, 16, 'rectangle', [1.2, 2.2]);
panel.position.set(-4.2, 1.6, 0);
panel.lookAt(-1, 1, 0.3);
const disc = shine(0xff5a9a, 18, 'disc', [1.6, 1.6]);
disc.position.set(4.2, 1.8, -0.6);
disc.lookAt(1, 0.9, 0.3);
const tubes = [-1, 0, 1].map((i) => {
  const tube = shine(i === 0 ? 0x60e0ff : 0x7a70ff, 40, 'tube', [2.6, 0.09]);
  tube.position.set(1.9 * i, 3 + 0.3 * Math.abs(i), -0.2);
  tube.rotation.z = 0.5 * i;
  return tube;
});
panel.castShadow = disc.castShadow = true;

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
  for (const pot of pots) pot.rotation.y = 0.4 * seconds;
  for (const [i, tube] of tubes.entries()) tube.rotation.z = 0.5 * (i - 1) + 0.3 * Math.sin(seconds + i);
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
