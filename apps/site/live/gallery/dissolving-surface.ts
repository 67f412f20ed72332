/**
 * A statue that dissolves
 *
 * A surface discards what its noise says and lets the rim glow; shadows have the same holes.
 *
 * @tags microshader, surface, shadows
 */
import { FarolRenderer } from '@farol/renderer';
import { Surface, setSurface } from '@farol/renderer/surfaces';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
webgl.toneMappingExposure = 2.2;
webgl.shadowMap.enabled = true;
const farol = new FarolRenderer(webgl, { technique: 'clustered-forward' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x08070a);
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 100);
camera.position.set(2.6, 1.8, 4.6);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.1, 0);
controls.update();

const dissolve = new Surface(
  'dissolve',
  `#include "surfaceNoise"
uniform float share; // = 0.5 [0, 1, 0.01] Share that is gone
uniform vec3 rimColor; // = #ff6a20 Colour of the rim
void surface(inout SurfaceData s) {
  float rest = farol_fractalNoise(s.positionOS * 5.0) - share;
  if (rest < 0.0) discard;
  s.emissive += rimColor * 4.0 * smoothstep(0.05, 0.0, rest);
}`,
);
const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(30, 30),
  new THREE.MeshStandardMaterial({ color: 0x9a9288, roughness: 0.8 }),
);
floor.rotation.x = -Math.PI / 2;
floor.receiveShadow = true;
const material = new THREE.MeshStandardMaterial({ color: 0xd8d2c8, roughness: 0.4, side: THREE.DoubleSide });
const statue = new THREE.Mesh(new THREE.TorusKnotGeometry(0.75, 0.27, 256, 48), material);
statue.position.y = 1.3;
statue.castShadow = statue.receiveShadow = true;
const values = setSurface(material, dissolve, { share: 0.4 });
scene.add(floor, statue, new THREE.HemisphereLight(0x8090c0, 0x302820, 0.12));
const spot = new THREE.SpotLight(0xffe0b8, 80, 14, 0.45, 0.6);
spot.position.set(2.5, 5, 3);
spot.target = statue;
spot.castShadow = true;
spot.shadow.mapSize.set(1024, 1024);
spot.shadow.normalBias = 0.03;
const back = new THREE.SpotLight(0x4a7aff, 50, 14, 0.5, 0.6);
back.position.set(-4, 3, -3);
back.target = statue;
back.castShadow = true;
back.shadow.normalBias = 0.03;
const ember = new THREE.PointLight(0xff6a20, 2.2, 4);
ember.position.y = 1.3;
scene.add(spot, back, ember);

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
  statue.rotation.y = 0.25 * seconds;
  values.share.value = 0.36 + 0.14 * Math.sin(0.8 * seconds);
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
