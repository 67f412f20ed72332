/**
 * Controls and labels
 *
 * OrbitControls, TransformControls (drag the arrows) and CSS2DRenderer's labels, over a picture by Farol.
 *
 * @tags controls, start
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';
import { CSS2DObject, CSS2DRenderer } from 'three/addons/renderers/CSS2DRenderer.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl);

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x090b11);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(3.4, 2.6, 5.4);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.9, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(30, 30),
  new THREE.MeshStandardMaterial({ color: 0x7d8088, roughness: 0.6 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0x8fa8d8, 0x302820, 0.25));
const words = ['lamp', 'teapot', 'knot', 'gem'];
const shapes = [
  new THREE.SphereGeometry(0.16, 32, 20),
  new TeapotGeometry(0.5, 14),
  new THREE.TorusKnotGeometry(0.42, 0.15, 160, 24),
  new THREE.IcosahedronGeometry(0.55, 0),
];
const things = shapes.map((shape, i) => {
  const color = new THREE.Color().setHSL(0.08 + 0.22 * i, 0.5, 0.6);
  const mesh = new THREE.Mesh(
    shape,
    i === 0
      ? new THREE.MeshBasicMaterial({ color: 0xffd8a0 })
      : new THREE.MeshStandardMaterial({ color, roughness: 0.3 }),
  );
  mesh.position.set([0, -1.7, 0.2, 1.7][i], [1.7, 0.52, 0.65, 0.55][i], [0.4, 0.2, -1.4, 0][i]);
  const element = document.createElement('span');
  element.textContent = words[i];
  element.style.cssText = 'padding: 2px 8px; border-radius: 6px; background: #000a; color: #fff';
  const label = new CSS2DObject(element);
  label.position.y = i === 0 ? 0.35 : 0.75;
  mesh.add(label);
  scene.add(mesh);
  return mesh;
});
things[0].add(new THREE.PointLight(0xffc890, 14, 9));
for (let i = 0; i < 10; i++) {
  const light = new THREE.PointLight(new THREE.Color().setHSL(i / 10, 0.8, 0.6), 2.6, 4);
  light.position.set(2.6 * Math.cos(0.63 * i), 0.4 + 0.2 * (i % 3), 2.6 * Math.sin(0.63 * i));
  scene.add(light);
}
const gizmo = new TransformControls(camera, canvas);
gizmo.attach(things[0]);
gizmo.addEventListener('dragging-changed', ({ value }) => (controls.enabled = !value));
scene.add(gizmo.getHelper());

const labels = new CSS2DRenderer();
labels.domElement.style.cssText = 'position: fixed; inset: 0; pointer-events: none';
document.body.append(labels.domElement);

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  farol.setPixelRatio(Math.min(devicePixelRatio, 2));
  farol.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();

webgl.setAnimationLoop(() => {
  labels.setSize(innerWidth, innerHeight);
  labels.render(scene, camera);
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
