/**
 * A room for headsets
 *
 * WebXR as three has it: `webgl.xr.enabled`, a button, and `farol.render` draws both eyes; grab a lamp by pointing at it.
 *
 * @tags WebXR, point light
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';
import { VRButton } from 'three/addons/webxr/VRButton.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-forward' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x06070c);
const camera = new THREE.PerspectiveCamera(60, 1, 0.1, 100);
camera.position.set(0, 1.6, 3.4);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.2, -0.5);
controls.update();

webgl.xr.enabled = true;
document.body.append(VRButton.createButton(webgl)); // the button says so where there is no headset

const wood = new THREE.MeshStandardMaterial({ color: 0x8a6a4a, roughness: 0.6 });
const room = new THREE.Mesh(
  new THREE.BoxGeometry(8, 3.4, 8),
  new THREE.MeshStandardMaterial({ color: 0x8f98a8, roughness: 0.85, side: THREE.BackSide }),
);
room.position.y = 1.7;
scene.add(room, new THREE.HemisphereLight(0x90a8e0, 0x403020, 0.25));
const table = new THREE.Mesh(new THREE.CylinderGeometry(0.9, 0.9, 0.06, 64), wood);
table.position.set(0, 0.9, -1);
const leg = new THREE.Mesh(new THREE.CylinderGeometry(0.08, 0.3, 0.9, 32), wood);
leg.position.set(0, 0.45, -1);
const pot = new THREE.Mesh(
  new TeapotGeometry(0.2, 14),
  new THREE.MeshStandardMaterial({ color: 0xd8e0e8, roughness: 0.15, metalness: 0.4 }),
);
pot.position.set(0, 1.13, -1);
scene.add(table, leg, pot);

const bulb = new THREE.SphereGeometry(0.07, 24, 16);
const lamps = Array.from({ length: 14 }, (_, i) => {
  const color = new THREE.Color().setHSL(i / 14, 0.8, 0.6);
  const lamp = new THREE.Mesh(bulb, new THREE.MeshBasicMaterial({ color }));
  lamp.add(new THREE.PointLight(color, 1.6, 3));
  const angle = (i / 14) * 2 * Math.PI;
  lamp.position.set(1.7 * Math.cos(angle), 1 + 0.35 * (i % 4), 1.7 * Math.sin(angle) - 1);
  scene.add(lamp);
  return lamp;
});

const ray = new THREE.Raycaster();
for (const hand of [0, 1]) {
  const controller = webgl.xr.getController(hand);
  const line = new THREE.BufferGeometry().setFromPoints([new THREE.Vector3(), new THREE.Vector3(0, 0, -3)]);
  controller.add(new THREE.Line(line, new THREE.LineBasicMaterial({ color: 0xffb454 })));
  controller.addEventListener('selectstart', () => {
    ray.setFromXRController(controller);
    const [hit] = ray.intersectObjects(lamps, false);
    if (hit) controller.attach(hit.object);
  });
  controller.addEventListener('selectend', () => {
    for (const lamp of lamps) if (lamp.parent === controller) scene.attach(lamp);
  });
  scene.add(controller);
}

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
  pot.rotation.y = 0.3 * seconds;
  for (const [i, lamp] of lamps.entries())
    if (lamp.parent === scene) lamp.position.y = 1 + 0.35 * (i % 4) + 0.1 * Math.sin(seconds + i);
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
