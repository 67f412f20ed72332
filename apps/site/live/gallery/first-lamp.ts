/**
 * First lamp
 *
 * A scene of three's, one lamp, and one line that changes: `farol.render` in place of `webgl.render`.
 *
 * @tags start, point light
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
webgl.shadowMap.enabled = true;
const farol = new FarolRenderer(webgl);

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x0a0f1c);
scene.add(new THREE.HemisphereLight(0x6f8fd8, 0x302820, 0.25));
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 60);
camera.position.set(2.4, 2, 4.6);

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(40, 40),
  new THREE.MeshStandardMaterial({ color: 0x8c8577, roughness: 0.8 }),
);
floor.rotation.x = -Math.PI / 2;
floor.receiveShadow = true;
scene.add(floor);

const stone = new THREE.MeshStandardMaterial({ color: 0xb9a88d, roughness: 0.6, flatShading: true });
for (let i = 0; i < 9; i++) {
  const angle = (i / 9) * 2 * Math.PI;
  const rock = new THREE.Mesh(new THREE.IcosahedronGeometry(0.35 + 0.2 * Math.sin(5 * i), 1), stone);
  rock.position.set(2.4 * Math.cos(angle), 0.3, 2.4 * Math.sin(angle));
  rock.rotation.set(i, 2 * i, 0);
  rock.castShadow = rock.receiveShadow = true;
  scene.add(rock);
}
const post = new THREE.Mesh(
  new THREE.CylinderGeometry(0.05, 0.09, 1.2, 16),
  new THREE.MeshStandardMaterial({ color: 0x2b2d33 }),
);
post.position.y = 0.6;
post.castShadow = true;
scene.add(post);

const lamp = new THREE.PointLight(0xffb454, 22, 12); // cd, and the range in m: always give one
lamp.castShadow = true;
lamp.shadow.radius = 3;
lamp.add(new THREE.Mesh(new THREE.SphereGeometry(0.12, 24, 16), new THREE.MeshBasicMaterial({ color: 0xffe2b0 })));
scene.add(lamp);

const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.8, 0);
controls.update();

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
  lamp.position.set(0.5 * Math.sin(seconds), 1.5 + 0.1 * Math.sin(2 * seconds), 0.5 * Math.cos(seconds));
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
