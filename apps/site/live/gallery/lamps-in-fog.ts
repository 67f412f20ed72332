/**
 * Lamps in fog
 *
 * Twelve street lamps and a moon light the fog, with their shadows: halos, beams and drifting mist over the ground.
 *
 * @tags effect, shadows, fog
 */
import { FarolRenderer } from '@farol/renderer';
import { FogVolume, VolumetricFog, fogQualities } from '@farol/renderer/volumetric-fog';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
webgl.shadowMap.enabled = true;
const fog = new VolumetricFog();
fog.froxels = fogQualities.low;
Object.assign(fog, { density: 0.035, anisotropy: 0.45, height: 1, falloff: 5, distance: 60, noise: 0.6, noiseSize: 3 });
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred', effects: [fog] });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x05070c);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 120);
camera.position.set(-1.2, 1.9, 10);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0.4, 1.9, 0);
controls.update();

const add = (
  geometry: THREE.BufferGeometry,
  color: number,
  x: number,
  y: number,
  z: number,
  roughness = 0.85,
): THREE.Mesh => {
  const mesh = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ color, roughness }));
  mesh.position.set(x, y, z);
  mesh.castShadow = mesh.receiveShadow = true;
  scene.add(mesh);
  return mesh;
};
add(new THREE.PlaneGeometry(80, 80), 0x3a3a40, 0, 0, -20, 0.7).rotation.x = -Math.PI / 2;
for (const side of [-1, 1]) {
  for (let i = 0; i < 7; i++)
    add(new THREE.BoxGeometry(4, 5 + ((i * 3) % 4), 4.4), 0x6a5a50, 7.6 * side, 2.5, 6 - 6 * i);
  for (let i = 0; i < 9; i++) add(new THREE.CylinderGeometry(0.09, 0.12, 1, 12), 0x282828, 2.6 * side, 0.5, 7 - 3 * i);
}
const pole = new THREE.CylinderGeometry(0.05, 0.08, 3.6, 12);
const bulb = new THREE.SphereGeometry(0.11, 16, 12);
const glow = new THREE.MeshBasicMaterial({ color: new THREE.Color(0xffd9a0).multiplyScalar(4) });
for (let i = 0; i < 12; i++) {
  const side = i % 2 ? 1 : -1;
  const z = 6 - 2.6 * i;
  add(pole, 0x202020, 3.4 * side, 1.8, z);
  add(new THREE.BoxGeometry(0.9, 0.06, 0.06), 0x202020, 3 * side, 3.6, z);
  const lamp = new THREE.SpotLight(i % 5 === 3 ? 0xa8c8ff : 0xffb868, 55, 11, 0.95, 0.6);
  lamp.position.set(2.6 * side, 3.45, z);
  lamp.target.position.set(1.9 * side, 0, z);
  lamp.castShadow = true;
  const shade = new THREE.Mesh(bulb, glow);
  shade.position.copy(lamp.position);
  scene.add(lamp, lamp.target, shade);
}
const moon = new THREE.DirectionalLight(0x8098d0, 0.5);
moon.position.set(-14, 18, -22);
moon.castShadow = true;
moon.shadow.mapSize.set(2048, 2048);
Object.assign(moon.shadow.camera, { left: -24, right: 24, top: 24, bottom: -24, far: 80 });
scene.add(moon, new THREE.HemisphereLight(0x304060, 0x100c08, 0.5));
const mist = new FogVolume('sphere');
mist.position.set(0, 0, -2);
mist.scale.set(7, 1.6, 16);
mist.density = 0.25;
scene.add(mist);

const box = document.createElement('label');
box.className = 'panel';
const check = Object.assign(document.createElement('input'), { type: 'checkbox', checked: true });
check.addEventListener('change', () => (farol.effects = check.checked ? [fog] : []));
box.append(check, 'Fog');
document.body.append(box);

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  farol.setPixelRatio(Math.min(devicePixelRatio, 2));
  farol.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();

webgl.setAnimationLoop((milliseconds) => {
  fog.time = milliseconds / 1000;
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
