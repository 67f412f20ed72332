/**
 * An effect of your own
 *
 * Mist that lies in the valley: a full-screen pass that reads the depth of whichever technique drew, in forty lines.
 *
 * @tags effect, authoring, microshader
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { ImprovedNoise } from 'three/addons/math/ImprovedNoise.js';
import {
  type FarolEffect,
  type Frame,
  FullscreenPass,
  setUnprojectUniforms,
  unprojectUniforms,
} from '@farol/renderer/authoring';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'forward-plus' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x0a1020);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(0, 3, 11);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.2, 0);
controls.update();

const mist = `// Lays mist over what is low, thicker the longer the way through it.
#include "unproject"
#include "viewport"
uniform highp sampler2D example_depth;
uniform mat4 example_toWorld;
uniform vec2 example_size;
layout(location = 0) out highp vec4 example_color;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
float depth = texelFetch(example_depth, pixel, 0).r;
vec3 positionVS = farol_unproject((vec2(pixel) + 0.5) / example_size, depth);
float height = (example_toWorld * vec4(positionVS, 1.0)).y;
float thick = (1.0 - smoothstep(0.0, 1.7, height)) * (1.0 - exp(0.09 * positionVS.z));
example_color = vec4(0.12, 0.2, 0.34, depth < 1.0 ? 0.95 * thick : 0.0);
`;

class Mist implements FarolEffect {
  readonly name = 'mist';
  readonly bytes = 0;
  private readonly size = new THREE.Vector2();
  private readonly pass = new FullscreenPass({
    program: 'mist',
    fragment: 'exampleMist',
    microShaders: { exampleMist: mist },
    shared: ['farol_offset'],
    uniforms: {
      ...unprojectUniforms(),
      example_depth: { value: null as THREE.Texture | null },
      example_toWorld: { value: new THREE.Matrix4() },
      example_size: { value: this.size },
    },
    transparent: true,
    blending: THREE.NormalBlending,
  });

  end(frame: Frame): void {
    const depth = frame.resources.find('scene-depth');
    if (depth === undefined) return;
    const { uniforms } = this.pass;
    setUnprojectUniforms(uniforms, frame.camera, frame.webgl);
    uniforms.example_depth.value = depth;
    uniforms.example_toWorld.value = frame.camera.matrixWorld;
    this.size.set(frame.width, frame.height);
    frame.bindTarget();
    this.pass.draw(frame);
  }

  dispose(): void {
    this.pass.dispose();
  }
}
farol.effects = [new Mist()];

const noise = new ImprovedNoise();
const land = new THREE.PlaneGeometry(60, 60, 160, 160).rotateX(-Math.PI / 2);
const places = land.attributes.position;
const heightAt = (x: number, z: number) =>
  1.6 * noise.noise(x / 5, 0, z / 5) + 0.4 * noise.noise(x / 1.6, 4, z / 1.6) + 0.8;
for (let i = 0; i < places.count; i++) places.setY(i, heightAt(places.getX(i), places.getZ(i)));
land.computeVertexNormals();
scene.add(
  new THREE.Mesh(land, new THREE.MeshStandardMaterial({ color: 0x8a8f80, roughness: 0.9 })),
  new THREE.HemisphereLight(0x90b0ff, 0x202830, 0.5),
);
const tree = new THREE.InstancedMesh(
  new THREE.ConeGeometry(0.35, 1.6, 9),
  new THREE.MeshStandardMaterial({ color: 0x3f5a48, roughness: 0.9 }),
  300,
);
for (let i = 0; i < 300; i++) {
  const x = 36 * (THREE.MathUtils.seededRandom() - 0.5);
  const z = 30 * (THREE.MathUtils.seededRandom() - 0.7);
  tree.setMatrixAt(i, new THREE.Matrix4().makeTranslation(x, heightAt(x, z) + 0.7, z));
}
scene.add(tree);
const lights = Array.from({ length: 40 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL(0.06 + 0.03 * (i % 3), 0.9, 0.6), 6, 4);
  light.add(new THREE.Mesh(new THREE.SphereGeometry(0.07, 12, 8), new THREE.MeshBasicMaterial({ color: 0xffd8a0 })));
  const x = 2.6 * ((i % 8) - 3.5) + Math.sin(7 * i);
  const z = 5 - 4 * Math.floor(i / 8) + Math.cos(5 * i);
  light.position.set(x, heightAt(x, z) + 0.8, z);
  scene.add(light);
  return light;
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
  for (const [i, light] of lights.entries()) light.intensity = 5 + 2 * Math.sin(2 * seconds + 3 * i);
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
