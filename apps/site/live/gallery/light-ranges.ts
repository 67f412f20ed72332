/**
 * Ranges shown
 *
 * A light's `distance` is its range: beyond it a light gives nothing and costs nothing, so give every light one.
 *
 * @tags start, point light, cost
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl);

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x07090e);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(7, 6.5, 11);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.4, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(60, 60),
  new THREE.MeshStandardMaterial({ color: 0x9a9fa8, roughness: 0.6 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0x8fa8d8, 0x202028, 0.15));
const knot = new THREE.TorusKnotGeometry(0.5, 0.17, 120, 20);
const white = new THREE.MeshStandardMaterial({ color: 0xe8e4dc, roughness: 0.35 });
const ball = new THREE.IcosahedronGeometry(1, 3);
const bulb = new THREE.SphereGeometry(0.07, 16, 12);

const lights: { light: THREE.PointLight; shell: THREE.LineSegments }[] = [];
for (let i = 0; i < 12; i++) {
  const light = new THREE.PointLight(new THREE.Color().setHSL(i / 12, 0.8, 0.6), 14);
  light.position.set(4.2 * ((i % 4) - 1.5), 1, 4.2 * (Math.floor(i / 4) - 1));
  const shell = new THREE.LineSegments(
    new THREE.WireframeGeometry(ball),
    new THREE.LineBasicMaterial({ color: light.color, transparent: true, opacity: 0.16 }),
  );
  light.add(shell, new THREE.Mesh(bulb, new THREE.MeshBasicMaterial({ color: light.color })));
  const thing = new THREE.Mesh(knot, white);
  thing.position.set(light.position.x + 1.2, 0.6, light.position.z + 0.6);
  scene.add(light, thing);
  lights.push({ light, shell });
}

const panel = document.createElement('label');
panel.className = 'panel';
panel.textContent = 'Range ';
const slider = Object.assign(document.createElement('input'), { type: 'range', min: '0.5', max: '6', step: '0.1' });
slider.value = '2.4';
const output = document.createElement('output');
panel.append(slider, output);
document.body.append(panel);
function show(): void {
  output.value = `${slider.value} m`;
  for (const { light, shell } of lights) shell.scale.setScalar((light.distance = Number(slider.value)));
}
slider.addEventListener('input', show);
show();

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
