/**
 * Waves by a surface
 *
 * A dozen lines of GLSL displace a plane and set its colour and roughness; lanterns light it as any other mesh.
 *
 * @tags microshader, surface, materials
 */
import { FarolRenderer } from '@farol/renderer';
import { Surface, setSurface } from '@farol/renderer/surfaces';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'tiled-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x060a14);
scene.fog = new THREE.Fog(0x060a14, 8, 26);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(0, 2.3, 9);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.6, 0);
controls.update();

const water = new Surface(
  'water',
  `#include "surfaceNoise"
float wave(vec3 p, float time) {
  return 0.22 * sin(1.1 * p.x + time) * sin(0.9 * p.y - 0.7 * time) + 0.3 * farol_noise(vec3(1.4 * p.xy, 0.5 * time));
}
void displace(inout VertexData v) {
  float h = wave(v.positionOS, v.time);
  vec2 slope = vec2(wave(v.positionOS + vec3(0.05, 0, 0), v.time), wave(v.positionOS + vec3(0, 0.05, 0), v.time)) - h;
  v.normalOS = normalize(vec3(-slope / 0.05, 1.0));
  v.positionOS.z += h;
}
void surface(inout SurfaceData s) {
  s.color = mix(vec3(0.02, 0.05, 0.12), vec3(0.14, 0.24, 0.42), farol_noise(s.positionOS * 1.4 + 0.3 * s.time));
  s.roughness = 0.22;
}`,
);
const sea = new THREE.Mesh(new THREE.PlaneGeometry(40, 40, 240, 240), new THREE.MeshStandardMaterial());
sea.rotation.x = -Math.PI / 2;
setSurface(sea.material, water);
scene.add(sea, new THREE.HemisphereLight(0x7090d0, 0x102030, 0.3));

const paper = new THREE.CylinderGeometry(0.22, 0.28, 0.5, 6, 1, true);
const raft = new THREE.CylinderGeometry(0.4, 0.36, 0.08, 24);
const wood = new THREE.MeshStandardMaterial({ color: 0x3a2a1c });
const lanterns = Array.from({ length: 26 }, (_, i) => {
  const lantern = new THREE.Group();
  const color = new THREE.Color().setHSL(0.05 + 0.04 * (i % 3), 0.95, 0.55);
  const shade = new THREE.Mesh(paper, new THREE.MeshBasicMaterial({ color, side: THREE.DoubleSide }));
  shade.position.y = 0.3;
  const light = new THREE.PointLight(color, 5, 4.5);
  light.position.y = 0.7;
  lantern.add(shade, new THREE.Mesh(raft, wood), light);
  const far = Math.floor(i / 4);
  lantern.position.set(2.6 * ((i % 4) - 1.5) + Math.sin(5 * i), 0, 4 - 2.5 * far + Math.cos(3 * i));
  scene.add(lantern);
  return lantern;
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
  water.time.value = seconds;
  for (const [i, lantern] of lanterns.entries()) {
    lantern.position.y = 0.2 + 0.16 * Math.sin(seconds + i);
    lantern.rotation.set(0.1 * Math.sin(0.9 * seconds + i), i, 0.1 * Math.cos(0.8 * seconds + i));
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
