/**
 * Multipass, one light at a time
 *
 * The thesis's `forward`: the ambient pass, then one additive pass a light. The slider stops it after so many lights.
 *
 * @tags technique, forward
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'forward' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x050609);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(3.6, 2.4, 5.2);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.9, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(30, 30),
  new THREE.MeshStandardMaterial({ color: 0xa8a196, roughness: 0.7 }),
);
floor.rotation.x = -Math.PI / 2;
const knot = new THREE.Mesh(
  new THREE.TorusKnotGeometry(0.7, 0.23, 200, 32),
  new THREE.MeshStandardMaterial({ color: 0xeee6d8, roughness: 0.3 }),
);
knot.position.y = 1.15;
scene.add(floor, knot, new THREE.HemisphereLight(0x8fa8d8, 0x302820, 0.12));
const bulb = new THREE.SphereGeometry(0.07, 16, 12);
const lights = Array.from({ length: 9 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL(i / 9, 0.9, 0.55), 7, 5);
  const angle = (i / 9) * 2 * Math.PI;
  light.position.set(1.9 * Math.cos(angle), 0.6 + 0.8 * (i % 2), 1.9 * Math.sin(angle));
  light.add(new THREE.Mesh(bulb, new THREE.MeshBasicMaterial({ color: light.color })));
  scene.add(light);
  return light;
});

const panel = document.createElement('label');
panel.className = 'panel';
const slider = Object.assign(document.createElement('input'), { type: 'range', min: '0', max: '9', value: '9' });
const output = document.createElement('output');
panel.append('Lights ', slider, output);
document.body.append(panel);
slider.addEventListener('input', () => {
  for (const [i, light] of lights.entries()) light.visible = i < Number(slider.value);
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
  knot.rotation.y = 0.3 * seconds;
  output.value = `${slider.value}: ${farol.info.drawCalls} draws`;
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
