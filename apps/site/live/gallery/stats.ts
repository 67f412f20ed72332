/**
 * Stats
 *
 * three's stats panel and stats-gl, which times the GPU round `webgl.render`, beside the figures of `farol.info`.
 *
 * @tags controls, cost
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';
import StatsGL from 'stats-gl';
import Stats from 'three/addons/libs/stats.module.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl);

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x07080d);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(0, 3, 7.4);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.9, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(30, 30),
  new THREE.MeshStandardMaterial({ color: 0x6f747e, roughness: 0.4 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0x8fa8d8, 0x302820, 0.2));
const bars = new THREE.InstancedMesh(
  new RoundedBoxGeometry(0.22, 1, 0.22, 3, 0.04),
  new THREE.MeshStandardMaterial({ roughness: 0.35 }),
  120,
);
const matrix = new THREE.Matrix4();
for (let i = 0; i < 120; i++) bars.setColorAt(i, new THREE.Color().setHSL(0.5 + i / 300, 0.5, 0.6));
bars.frustumCulled = false;
scene.add(bars);
const lights = Array.from({ length: 48 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL(i / 48, 0.85, 0.6), 3, 3.2);
  scene.add(light);
  return light;
});

const frames = new Stats();
frames.dom.style.cssText = 'position: fixed; right: 0; bottom: 0';
const gpu = new StatsGL({ trackGPU: true }); // while it times, Farol's own `timing` has no figures
await gpu.init(webgl);
Object.assign(gpu.dom.style, { top: 'auto', bottom: '48px' });
const output = document.createElement('output');
output.className = 'panel';
document.body.append(frames.dom, gpu.dom, output);

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
  for (let i = 0; i < 120; i++) {
    const [x, z] = [(i % 20) - 9.5, Math.floor(i / 20) - 2.5];
    const height = 0.5 + 0.45 * Math.sin(0.5 * x + seconds) * Math.cos(0.8 * z + 0.7 * seconds) + 0.5;
    bars.setMatrixAt(i, matrix.makeScale(1, height, 1).setPosition(0.36 * x, height / 2, 0.5 * z));
  }
  bars.instanceMatrix.needsUpdate = true;
  for (const [i, light] of lights.entries()) {
    const angle = 0.4 * seconds + 2.4 * i;
    light.position.set(0.55 * Math.sqrt(i) * Math.cos(angle), 1.5, 0.4 * Math.sqrt(i) * Math.sin(angle));
  }
  frames.update();
  gpu.update();
  output.value = `${farol.info.technique}: ${farol.info.drawCalls} draws, ${farol.info.lights.visible} lights`;
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
