/**
 * Edit a microshader while it runs
 *
 * How light falls off is one GLSL function: change it below. What does not compile says why, and the picture stays.
 *
 * @tags microshader, point light
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x050609);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(0, 7, 7.4);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0, 0.6);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(40, 40),
  new THREE.MeshStandardMaterial({ color: 0xb4aea4, roughness: 0.8 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor);
const peg = new THREE.CapsuleGeometry(0.22, 0.5, 12, 32);
for (let i = 0; i < 35; i++) {
  const mesh = new THREE.Mesh(peg, new THREE.MeshStandardMaterial({ color: 0xf0e8dc, roughness: 0.5 }));
  mesh.position.set(1.6 * ((i % 7) - 3), 0.45, 1.6 * (Math.floor(i / 7) - 2));
  scene.add(mesh);
}
const lights = Array.from({ length: 7 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL(i / 7, 0.8, 0.6), 6, 3.4);
  scene.add(light);
  return light;
});

const chunk = farol.microshaders.get('lightAttenuation')!;
// published GLSL has no blanks round operators, hence ` ?`
const line = /float falloff ?= ?window[^;]*;/;
const original =
  'float falloff = window * window / max(decay == 2.0 ? distanceSquared : pow(distanceSquared, 0.5 * decay), 0.01);';
const presets: Record<string, string> = {
  Rings: 'float falloff = 0.6 * window * smoothstep(-0.2, 0.5, sin(9.0 * sqrt(distanceSquared)));',
  'As three has it': original,
  'A plain disc': 'float falloff = 0.5 * step(ratioSquared, 0.5);',
  Straight: 'float falloff = 0.7 * max(0.0, 1.0 - sqrt(ratioSquared));',
};
const panel = document.createElement('div');
panel.className = 'panel';
panel.style.flexDirection = 'column';
const select = document.createElement('select');
select.ariaLabel = 'Begin with';
select.append(...Object.keys(presets).map((name) => new Option(name)));
const text = Object.assign(document.createElement('textarea'), { rows: 3, cols: 46, spellcheck: false });
text.ariaLabel = 'Attenuation, GLSL';
text.style.cssText = 'font: 12px monospace; max-width: 100%';
const problem = document.createElement('output');
panel.append(select, text, problem);
document.body.append(panel);
function compile(): void {
  try {
    farol.microshaders.replace('lightAttenuation', { ...chunk, header: chunk.header.replace(line, () => text.value) });
    problem.value = '';
  } catch (error) {
    problem.value = String(error).slice(0, 200); // the microshader that last compiled goes on drawing
  }
}
function choose(): void {
  text.value = presets[select.value];
  compile();
}
select.addEventListener('change', choose);
text.addEventListener('input', compile);
choose();

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
  for (const [i, light] of lights.entries()) {
    const angle = 0.3 * seconds + (i / 7) * 2 * Math.PI;
    light.position.set(3.4 * Math.cos(angle), 0.7, 2.4 * Math.sin(angle));
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
