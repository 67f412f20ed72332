/**
 * Coloured glass under lamps
 *
 * Transparent panes are lit by all lamps, by the same lists as everything else, in deferred techniques too.
 *
 * @tags transparency, point light
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'tiled-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x07080c);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(1.2, 2, 6);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.7, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(40, 40),
  new THREE.MeshStandardMaterial({ color: 0x6d655c, roughness: 0.45 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0x90a0d0, 0x302820, 0.15));

const lead = new THREE.MeshStandardMaterial({ color: 0x1c1d20, roughness: 0.5, metalness: 0.6 });
const bar = new THREE.BoxGeometry(0.08, 3.6, 0.1);
const pane = new THREE.BoxGeometry(0.5, 0.5, 0.04);
for (let wall = 0; wall < 3; wall++) {
  const screen = new THREE.Group();
  screen.position.set(2.6 * (wall - 1), 0, wall === 1 ? -0.9 : 0.2);
  screen.rotation.y = 0.55 * (1 - wall);
  for (let x = 0; x <= 4; x++) {
    const post = new THREE.Mesh(bar, lead);
    post.position.set(0.58 * (x - 2), 1.8, 0);
    screen.add(post);
  }
  for (let i = 0; i < 24; i++) {
    const color = new THREE.Color().setHSL((0.61 * i + 0.2 * wall) % 1, 0.85, 0.5);
    const glass = new THREE.Mesh(
      pane,
      new THREE.MeshStandardMaterial({
        color,
        transparent: true,
        opacity: 0.55,
        roughness: 0.12,
        side: THREE.DoubleSide,
      }),
    );
    glass.position.set(0.58 * ((i % 4) - 1.5), 0.4 + 0.58 * Math.floor(i / 4), 0);
    screen.add(glass);
  }
  scene.add(screen);
}
const bulb = new THREE.SphereGeometry(0.06, 16, 12);
const lamps = Array.from({ length: 16 }, (_, i) => {
  const lamp = new THREE.PointLight(new THREE.Color().setHSL(0.08 + 0.03 * (i % 3), 0.8, 0.65), 5, 5);
  lamp.add(new THREE.Mesh(bulb, new THREE.MeshBasicMaterial({ color: 0xffe6c0 })));
  scene.add(lamp);
  return lamp;
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
  for (const [i, lamp] of lamps.entries()) {
    const angle = 0.35 * seconds * (i % 2 ? 1 : -1) + (i * Math.PI) / 8;
    lamp.position.set(4 * Math.cos(angle), 0.5 + 0.35 * (i % 8), (i % 2 ? 1.6 : -2.2) + 1.1 * Math.sin(angle));
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
