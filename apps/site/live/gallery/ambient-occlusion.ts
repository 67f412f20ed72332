/**
 * Ambient occlusion
 *
 * Indirect light reaches less into corners (GTAO): an effect that reads the technique's own depth and normals.
 *
 * @tags effect, deferred
 */
import { FarolRenderer } from '@farol/renderer';
import { AmbientOcclusion } from '@farol/renderer/ambient-occlusion';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
webgl.toneMappingExposure = 0.9;
const occlusion = new AmbientOcclusion();
const farol = new FarolRenderer(webgl, { technique: 'forward-plus', effects: [occlusion] });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x39445a);
const camera = new THREE.PerspectiveCamera(38, 1, 0.1, 100);
camera.position.set(5.6, 4.6, 7);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.5, 0);
controls.update();

const clay = new THREE.MeshStandardMaterial({ color: 0xf2ece2, roughness: 0.9 });
const ground = new THREE.Mesh(new THREE.PlaneGeometry(60, 60), clay);
ground.rotation.x = -Math.PI / 2;
scene.add(ground, new THREE.HemisphereLight(0xe2ecff, 0xcbb9a2, 1.5));
const blocks = new THREE.InstancedMesh(new RoundedBoxGeometry(1, 1, 1, 3, 0.06), clay, 180);
const place = new THREE.Object3D();
for (let i = 0; i < 180; i++) {
  const ring = Math.floor(Math.sqrt(i));
  const angle = 2.4 * i;
  place.position.set(
    0.32 * ring * Math.cos(angle),
    0.25 + 0.16 * Math.max(0, 10 - ring) * THREE.MathUtils.seededRandom(),
    0.32 * ring * Math.sin(angle),
  );
  place.rotation.set(0, angle, i % 5 ? 0 : 0.7);
  place.scale.setScalar(0.35 + 0.4 * THREE.MathUtils.seededRandom());
  place.updateMatrix();
  blocks.setMatrixAt(i, place.matrix);
}
scene.add(blocks);
const lamps = Array.from({ length: 8 }, (_, i) => {
  const lamp = new THREE.PointLight(new THREE.Color().setHSL(0.05 + 0.02 * i, 0.9, 0.6), 5, 4);
  scene.add(lamp);
  return lamp;
});
const box = document.createElement('label');
box.className = 'panel';
const check = Object.assign(document.createElement('input'), { type: 'checkbox', checked: true });
check.addEventListener('change', () => (farol.effects = check.checked ? [occlusion] : []));
box.append(check, 'Ambient occlusion');
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
  const seconds = milliseconds / 1000;
  for (const [i, lamp] of lamps.entries()) {
    const angle = (i / 8) * 2 * Math.PI + 0.3 * seconds;
    lamp.position.set(2.8 * Math.cos(angle), 0.6, 2.8 * Math.sin(angle));
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
