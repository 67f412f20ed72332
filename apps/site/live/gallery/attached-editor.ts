/**
 * The editor over a page
 *
 * A page of stock three that knows nothing of Farol gets tree, inspector, gizmo and undo by one call: `attachEditor`.
 *
 * @tags editor, start
 */
import { attachEditor } from '@farol/attach';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x0a0c12);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(3, 2.6, 5);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.8, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(20, 20),
  new THREE.MeshStandardMaterial({ color: 0x8a8478, roughness: 0.7 }),
);
floor.name = 'floor';
floor.rotation.x = -Math.PI / 2;
const pot = new THREE.Mesh(
  new TeapotGeometry(0.8, 12),
  new THREE.MeshStandardMaterial({ color: 0xc96a4a, roughness: 0.3 }),
);
pot.name = 'teapot';
pot.position.y = 0.82;
scene.add(floor, pot, new THREE.HemisphereLight(0x8fa8d8, 0x40342a, 0.4));
for (let i = 0; i < 6; i++) {
  const lamp = new THREE.PointLight(new THREE.Color().setHSL(i / 6, 0.8, 0.6), 8, 6);
  lamp.name = `lamp ${i + 1}`;
  lamp.position.set(2.2 * Math.cos((i * Math.PI) / 3), 1 + 0.4 * (i % 3), 2.2 * Math.sin((i * Math.PI) / 3));
  lamp.add(new THREE.Mesh(new THREE.SphereGeometry(0.06, 16, 12), new THREE.MeshBasicMaterial({ color: lamp.color })));
  scene.add(lamp);
}

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  webgl.setPixelRatio(Math.min(devicePixelRatio, 2));
  webgl.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();
webgl.setAnimationLoop(() => webgl.render(scene, camera)); // stock three goes on drawing the page

const editor = attachEditor(scene, camera, webgl);
editor.selected = pot;

const farol = editor.drawWith('clustered-deferred').then(() => editor.farol!);
export { camera, farol, scene, webgl };
