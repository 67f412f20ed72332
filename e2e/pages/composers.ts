import { FarolRenderer, type TechniqueName } from '@farol/renderer';
import { FarolPostPass } from '@farol/renderer/postprocessing';
import { FarolPass } from '@farol/renderer/three-pass';
import * as pmndrs from 'postprocessing';
import * as THREE from 'three';
import { EffectComposer } from 'three/addons/postprocessing/EffectComposer.js';
import type { RenderPass as ThreeRenderPass } from 'three/addons/postprocessing/RenderPass.js';
import { RenderPass } from 'three/addons/postprocessing/RenderPass.js';
import { ShaderPass } from 'three/addons/postprocessing/ShaderPass.js';
import { compareImages, type Difference, type FloatImage, isFlat } from '../support/images';

const WIDTH = 96;
const HEIGHT = 72;

/** Changes of a case to the pass that draws the scene, and to the composer round it. */
export interface Case {
  /** Properties that are set on the pass. */
  pass?: Partial<Pick<ThreeRenderPass, 'clear' | 'clearDepth' | 'clearAlpha'>> & { ignoreBackground?: boolean };
  clearColor?: number;
  override?: 'normal' | 'lit';
  /** Samples of the composer's buffers. */
  samples?: number;
  /** Draws a sphere by stock three into the buffer first. */
  before?: boolean;
  /** Shows the depth texture of the buffer in place of the picture. */
  depth?: boolean;
  /** Without a background, which the clear colour then fills. */
  bare?: boolean;
}

export interface Result extends Difference {
  flat: boolean;
  /** Whether the renderer and the scene are as they were. */
  kept: boolean;
}

/** Draws a case by a technique and by stock three, in three's composer, postprocessing's, or by `setEffects`. */
export type Compare = (host: 'three' | 'pmndrs' | 'effects', technique: TechniqueName, options: Case) => Result;

declare global {
  interface Window {
    compareInComposer: Compare;
  }
}

const webgl = new THREE.WebGLRenderer({ antialias: false });
webgl.setSize(WIDTH, HEIGHT, false);
webgl.setClearColor(0x223344, 0.5);
const farol = new FarolRenderer(webgl);
const effectsWebgl = new THREE.WebGLRenderer({ antialias: false, outputBufferType: THREE.HalfFloatType });
effectsWebgl.setSize(WIDTH, HEIGHT, false);
effectsWebgl.toneMapping = THREE.ACESFilmicToneMapping;
const effectsFarol = new FarolRenderer(effectsWebgl);

const camera = new THREE.PerspectiveCamera(50, WIDTH / HEIGHT, 0.1, 20);
camera.position.set(0, 1.5, 4);
camera.lookAt(0, 0, 0);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0x304050);
const ball = new THREE.SphereGeometry(0.7, 24, 16);
const materials = [
  new THREE.MeshStandardMaterial({ color: 0xcc8866, roughness: 0.4, metalness: 0.3 }),
  new THREE.MeshLambertMaterial({ color: 0x66aacc }),
  new THREE.MeshPhongMaterial({ color: 0x88cc66, transparent: true, opacity: 0.5 }),
];
materials.forEach((material, i) => {
  const mesh = new THREE.Mesh(ball, material);
  mesh.position.set(i - 1, 0.3 * i, 0.5 * i - 0.5);
  scene.add(mesh);
});
for (let i = 0; i < 6; i++) {
  const light = new THREE.PointLight(new THREE.Color().setHSL(i / 6, 0.6, 0.6), 4, 5);
  light.position.set(2 * Math.cos(i), 1 + (i % 3) / 2, 2 * Math.sin(i));
  scene.add(light);
}
const sphere = new THREE.Scene();
sphere.add(new THREE.Mesh(new THREE.SphereGeometry(0.8), new THREE.MeshBasicMaterial({ color: 0xff8800 })));

const depthShader = {
  uniforms: { tDiffuse: { value: null }, depth: { value: null as THREE.Texture | null } },
  vertexShader: 'varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }',
  fragmentShader:
    'uniform sampler2D depth; varying vec2 at; void main() { gl_FragColor = vec4(vec3(pow(texture2D(depth, at).r, 40.0)), 1.0); }',
};

function read(target: THREE.WebGLRenderTarget) {
  const data = new Float32Array(WIDTH * HEIGHT * 4);
  webgl.readRenderTargetPixels(target, 0, 0, WIDTH, HEIGHT, data);
  return { width: WIDTH, height: HEIGHT, data };
}

function readCanvas(of: THREE.WebGLRenderer) {
  const bytes = new Uint8Array(WIDTH * HEIGHT * 4);
  const gl = of.getContext();
  gl.readPixels(0, 0, WIDTH, HEIGHT, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  const decode = (c: number) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  return { width: WIDTH, height: HEIGHT, data: Array.from(bytes, (byte) => decode(byte / 255)) };
}

const overrides = { normal: new THREE.MeshNormalMaterial(), lit: new THREE.MeshLambertMaterial() };
const overrideOf = ({ override }: Case) => (override ? overrides[override] : null);

function byThree(byFarol: boolean, options: Case) {
  const target = new THREE.WebGLRenderTarget(WIDTH, HEIGHT, { type: THREE.FloatType, samples: options.samples ?? 0 });
  target.depthTexture = new THREE.DepthTexture(WIDTH, HEIGHT, THREE.FloatType);
  const composer = new EffectComposer(webgl, target);
  composer.renderToScreen = false;
  if (options.before) composer.addPass(new RenderPass(sphere, camera));
  const color = options.clearColor === undefined ? null : new THREE.Color(options.clearColor);
  const pass = byFarol
    ? new FarolPass(farol, scene, camera, overrideOf(options), color)
    : new RenderPass(scene, camera, overrideOf(options), color);
  Object.assign(pass, options.pass);
  composer.addPass(pass);
  const shown = composer.readBuffer;
  if (options.depth) {
    const show = new ShaderPass(depthShader);
    show.uniforms.depth.value = shown.depthTexture;
    composer.addPass(show);
  }
  composer.render(0);
  const image = read(options.depth ? composer.readBuffer : shown);
  composer.dispose();
  return image;
}

function byPmndrs(byFarol: boolean, options: Case) {
  const composer = new pmndrs.EffectComposer(webgl, {
    frameBufferType: THREE.FloatType,
    multisampling: options.samples ?? 0,
  });
  composer.autoRenderToScreen = false;
  const override = overrideOf(options) ?? undefined;
  const pass = byFarol
    ? new FarolPostPass(farol, scene, camera, override)
    : new pmndrs.RenderPass(scene, camera, override);
  Object.assign(pass, options.pass);
  if (options.clearColor !== undefined) pass.clearPass.overrideClearColor = new THREE.Color(options.clearColor);
  composer.addPass(pass);
  composer.render(0);
  const image = read(composer.inputBuffer);
  composer.dispose();
  webgl.autoClear = true;
  return image;
}

function byEffects(byFarol: boolean) {
  effectsWebgl.setEffects([byFarol ? new FarolPass(effectsFarol, scene, camera) : new RenderPass(scene, camera)]);
  effectsWebgl.render(scene, camera);
  return readCanvas(effectsWebgl);
}

const state = () =>
  JSON.stringify([
    webgl.getClearColor(new THREE.Color()),
    webgl.getClearAlpha(),
    webgl.autoClear,
    webgl.getRenderTarget() === null,
    scene.overrideMaterial,
    (scene.background as THREE.Color | null)?.getHex?.(),
    camera.layers.mask,
  ]);

window.compareInComposer = (host, technique, options) => {
  const { background } = scene;
  if (options.bare) scene.background = null;
  farol.technique = effectsFarol.technique = technique;
  const drawBy = { three: byThree, pmndrs: byPmndrs, effects: byEffects }[host];
  const draw = (byFarol: boolean): FloatImage => {
    webgl.setClearColor(0x223344, 0.5); // set anew, since a background of the frame before changes it
    return drawBy(byFarol, options);
  };
  try {
    const stock = draw(false);
    webgl.setRenderTarget(null);
    const before = state();
    const image = draw(true);
    webgl.setRenderTarget(null);
    return { ...compareImages(image, stock), flat: isFlat(stock), kept: state() === before };
  } finally {
    scene.background = background;
  }
};
